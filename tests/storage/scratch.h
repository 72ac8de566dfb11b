#pragma once

#include <stdlib.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "libvehicle/result/time_history.h"

namespace vehicle::test {

/// A folder of its own for one test, gone with it.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "vehicle-storage-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder " + name);
    folder_ = name;
  }
  ~Scratch() { std::filesystem::remove_all(folder_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  /// Names in the folder: what a failed write may have left behind.
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

 private:
  std::filesystem::path folder_;
};

inline std::string contentOf(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline void put(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// Values that a careless writer loses: shortest and longest texts, the smallest and largest doubles, minus zero.
inline TimeHistory awkwardHistory() {
  using Limits = std::numeric_limits<double>;
  TimeHistory history({{"carbody.z", "m"}, {"strange, \"quoted\" name", "N/m^2"}, {"ratio", "-"}});
  const std::vector<double> values = {0.0,
                                      -0.0,
                                      0.1,
                                      1.0 / 3.0,
                                      -2.2250738585072014e-308,
                                      Limits::denorm_min(),
                                      Limits::max(),
                                      -Limits::max(),
                                      9007199254740993.0,
                                      1e23,
                                      5e-324,
                                      123456789.0};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto row = history.append(0.005 * static_cast<double>(i));
    row[1] = values[i];
    row[2] = std::nextafter(values[i], 1.0);
    row[3] = -values[values.size() - 1 - i];
  }
  return history;
}

/// A history whose values all tell which version it is.
inline TimeHistory numberedHistory(int version, int samples) {
  TimeHistory history(std::vector<Channel>{{"carbody.z", "m"}});
  for (int i = 0; i < samples; ++i) history.append(i)[1] = version;
  return history;
}

}  // namespace vehicle::test
