#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace vehicle::test {

/// A room as libvehicle/CMakeLists.txt declares it and as its own CMakeLists.txt lists its files.
struct Room {
  int line = 0;                    // of its declaration
  std::set<std::string> uses;      // the arrows
  std::set<std::string> publicly;  // libraries that its users see too
  std::set<std::string> privately;
  std::set<std::string> headers;  // its public headers
  std::set<std::string> files;    // all of its files, headers included
};

/// What stands in the tree and should not: "file:line: message", ready for an editor.
using Violations = std::vector<std::string>;

/// The arrows and files of libvehicle as CMake reads them: the only place where they are written.
class House {
 public:
  /// @param root  folder that holds libvehicle/CMakeLists.txt
  /// @throws std::runtime_error if that file is missing or declares no room
  explicit House(const std::filesystem::path& root);

  [[nodiscard]] const std::map<std::string, Room>& rooms() const { return rooms_; }
  /// Whether a room may include headers of a library: its own, or one that a room below passes on.
  [[nodiscard]] bool sees(const std::string& room, const std::string& library) const;
  /// Arrows that point upward or nowhere: rooms are declared from the ground up.
  [[nodiscard]] Violations wrongArrows() const;

 private:
  std::map<std::string, Room> rooms_;
};

}  // namespace vehicle::test
