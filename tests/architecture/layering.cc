#include "tests/architecture/layering.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace vehicle::test {

namespace fs = std::filesystem;

namespace {

// Which library a header belongs to; the first fitting start counts.
struct Header {
  std::string_view start;
  std::string_view target;
};
constexpr Header kHeaders[] = {
    {"Eigen/", "Eigen3::Eigen"},
    {"unsupported/Eigen/", "Eigen3::Eigen"},
    {"Simbody.h", "vehicle_simbody"},
    {"SimTK", "vehicle_simbody"},
    {"simbody/", "vehicle_simbody"},
    {"simmath/", "vehicle_simbody"},
    {"hdf5.h", "vehicle_hdf5"},
    {"hwloc.h", "vehicle_hwloc"},
    {"H5", "vehicle_hdf5"},
    {"boost/", "Boost::headers"},
    {"pagmo/", "Pagmo::pagmo"},
    {"mpi.h", "MPI::MPI_CXX"},
    {"sqlite3.h", "SQLite::SQLite3"},
    {"tinyxml2.h", "tinyxml2::tinyxml2"},
    {"fmt/", "fmt::fmt"},
    {"CLI/", "CLI11::CLI11"},
    {"nlohmann/", "nlohmann_json::nlohmann_json"},
};
constexpr std::string_view kSystemHeaders[] = {"fcntl.h",  "poll.h",   "pthread.h", "sched.h",
                                               "signal.h", "stdlib.h", "termios.h", "unistd.h"};
constexpr std::string_view kOnlyForApps = "CLI11::CLI11";
// Simbody's headers are C++17 and change with NDEBUG: one source file is compiled for them.
constexpr std::string_view kSimbodyFile = "libvehicle/mbs/simbody_model.cc";
// SIMD types are for kernels, which are compiled apart for each instruction set.
constexpr std::string_view kSimdFile = "libvehicle/ensemble/kernel.inc";

constexpr std::string_view kTopEntries[] = {".ci",        ".clang-format", ".clang-tidy",    ".git",
                                            ".gitignore", "CHANGELOG.md",  "CMakeLists.txt", "CMakePresets.json",
                                            "LICENSE",    "README.md",     "apps",           "benchmarks",
                                            "docs",       "libvehicle",    "models",         "tests",
                                            "tools"};

bool isCpp(const fs::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".h" || extension == ".cc" || extension == ".inc";
}

// C++ files below root/folder as paths from the root, in alphabetical order.
std::vector<std::string> cppFiles(const fs::path& root, const std::string& folder) {
  std::vector<std::string> files;
  if (!fs::exists(root / folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    if (entry.is_regular_file() && isCpp(entry.path())) files.push_back(fs::relative(entry.path(), root).string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// "libvehicle/flat/flat_form.h" -> "flat"; empty outside the rooms.
std::string roomOf(const std::string& path) {
  constexpr std::string_view kLibrary = "libvehicle/";
  if (!path.starts_with(kLibrary)) return "";
  const std::size_t slash = path.find('/', kLibrary.size());
  return slash == std::string::npos ? "" : path.substr(kLibrary.size(), slash - kLibrary.size());
}

// The file as its room's CMakeLists.txt lists it: "libvehicle/study/plan/design_plan.h" -> "plan/design_plan.h".
std::string pathInRoom(const std::string& file) {
  return fs::path(file).lexically_relative(fs::path("libvehicle") / roomOf(file)).string();
}

std::string_view libraryOf(std::string_view header) {
  for (const Header& known : kHeaders) {
    if (header.starts_with(known.start)) return known.target;
  }
  return {};
}

bool isStandard(std::string_view header) {
  if (header.find('.') == std::string_view::npos) return header.find('/') == std::string_view::npos;
  return header.starts_with("sys/") || header.starts_with("linux/") ||
         std::ranges::find(kSystemHeaders, header) != std::end(kSystemHeaders);
}

// What an #include line names, with the quote or bracket before it: `"a/b.h`, `<cmath`; empty for any other line.
std::string includedBy(const std::string& line) {
  std::istringstream words(line);
  char hash = 0;
  char open = 0;
  char letter = 0;
  words >> hash;
  for (const char expected : std::string_view("include")) {
    if (hash != '#' || !(words >> letter) || letter != expected) return "";
    words >> std::noskipws;
  }
  words >> std::skipws >> open;
  std::string name;
  if ((open != '"' && open != '<') || !std::getline(words, name, open == '<' ? '>' : '"')) return "";
  return open + name;
}

// What is wrong with including a project header there.
std::optional<std::string> judgeOwn(const House& house, const std::string& file, const std::string& header) {
  const std::string from = roomOf(file);
  const std::string to = roomOf(header);
  if (!header.starts_with("libvehicle/") && !header.starts_with("apps/")) {
    return "\"" + header + "\" is no path from the top folder";
  }
  if (from.empty() || from == to) return std::nullopt;
  if (to.empty() || !house.rooms().contains(to)) return "\"" + header + "\" is in no room";
  if (house.rooms().at(from).uses.contains(to)) return std::nullopt;
  return "room " + from + " does not use room " + to + " (\"" + header + "\")";
}

// What is wrong with including a library's or the system's header there.
std::optional<std::string> judgeLibrary(const House& house, const std::string& file, const std::string& header) {
  if (header == "experimental/simd") {
    if (file == kSimdFile) return std::nullopt;
    return "<" + header + "> belongs in " + std::string(kSimdFile) + " alone";
  }
  const std::string library(libraryOf(header));
  if (library.empty()) {
    if (isStandard(header)) return std::nullopt;
    return "<" + header + "> is unknown; name its library in tests/architecture/layering.cc";
  }
  const std::string room = roomOf(file);
  if (room.empty()) return std::nullopt;
  if (library == kOnlyForApps) {
    return "<" + header + "> belongs in apps/ alone";
  }
  if (!house.sees(room, library)) return "room " + room + " does not declare " + library + " (<" + header + ">)";
  if (library == "vehicle_simbody" && file != kSimbodyFile) {
    return "<" + header + "> belongs in " + std::string(kSimbodyFile) + " alone";
  }
  const Room& own = house.rooms().at(room);
  if (own.privately.contains(library) && own.headers.contains(pathInRoom(file))) {
    return "<" + header + "> is private to room " + room + " and stands in a public header";
  }
  return std::nullopt;
}

}  // namespace

Violations wrongIncludes(const fs::path& root) {
  const House house(root);
  Violations found;
  std::vector<std::string> files = cppFiles(root, "libvehicle");
  for (const std::string& file : cppFiles(root, "apps")) files.push_back(file);
  for (const std::string& file : files) {
    if (!roomOf(file).empty() && !house.rooms().contains(roomOf(file))) continue;  // wrongFiles() names its folder
    std::ifstream stream(root / file);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
      ++number;
      const std::string name = includedBy(line);
      if (name.empty()) continue;
      const std::string header = name.substr(1);
      const auto wrong = name[0] == '"' ? judgeOwn(house, file, header) : judgeLibrary(house, file, header);
      if (wrong) found.push_back(file + ":" + std::to_string(number) + ": " + *wrong);
    }
  }
  return found;
}

Violations wrongFiles(const fs::path& root) {
  const House house(root);
  Violations found;
  for (const auto& entry : fs::directory_iterator(root / "libvehicle")) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && !house.rooms().contains(name)) {
      found.push_back("libvehicle/" + name + ":1: no vehicle_room() declares this folder");
    }
  }
  for (const std::string& file : cppFiles(root, "libvehicle")) {
    const auto room = house.rooms().find(roomOf(file));
    if (room == house.rooms().end() || room->second.files.contains(pathInRoom(file))) continue;
    found.push_back(file + ":1: libvehicle/" + room->first + "/CMakeLists.txt does not list this file");
  }
  for (const auto& [name, room] : house.rooms()) {
    for (const std::string& file : room.files) {
      if (fs::exists(root / "libvehicle" / name / file)) continue;
      found.push_back("libvehicle/" + name + "/CMakeLists.txt:1: lists " + file + ", which does not exist");
    }
  }
  return found;
}

Violations longFiles(const fs::path& root) {
  constexpr int kMost = 400;
  Violations found;
  for (const std::string folder : {"apps", "benchmarks", "libvehicle", "tests"}) {
    for (const std::string& file : cppFiles(root, folder)) {
      std::ifstream stream(root / file);
      int lines = 0;
      for (std::string line; std::getline(stream, line);) ++lines;
      if (lines <= kMost) continue;
      found.push_back(file + ":" + std::to_string(kMost + 1) + ": the file has " + std::to_string(lines) +
                      " lines, at most " + std::to_string(kMost) + "; split it by ideas");
    }
  }
  return found;
}

Violations strayEntries(const fs::path& root) {
  // Enough of .gitignore for the top folder: "/name/", "/name" and "*.ending".
  std::vector<std::string> ignored;
  std::ifstream stream(root / ".gitignore");
  for (std::string line; std::getline(stream, line);) {
    if (line.ends_with('/')) line.pop_back();
    if (line.starts_with('/')) line.erase(0, 1);
    if (!line.empty()) ignored.push_back(line);
  }
  const auto ignores = [&ignored](const std::string& name) {
    return std::ranges::any_of(ignored, [&name](const std::string& pattern) {
      return pattern.starts_with('*') ? name.ends_with(pattern.substr(1)) : name == pattern;
    });
  };
  Violations found;
  for (const auto& entry : fs::directory_iterator(root)) {
    const std::string name = entry.path().filename().string();
    if (std::ranges::find(kTopEntries, name) != std::end(kTopEntries) || ignores(name)) continue;
    found.push_back(name + ":1: has no place in the top folder");
  }
  return found;
}

}  // namespace vehicle::test
