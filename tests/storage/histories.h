#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "libvehicle/result/time_history.h"

namespace vehicle::test {

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
