#include "tests/architecture/house.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace vehicle::test {

namespace fs = std::filesystem;

namespace {

struct Call {
  int line = 0;
  std::vector<std::string> arguments;
};

// All calls of one CMake command; neither quotes nor variables occur in these files.
std::vector<Call> callsOf(const std::string& command, const fs::path& path) {
  std::ifstream stream(path);
  std::vector<Call> calls;
  bool open = false;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    line = line.substr(0, line.find('#'));
    line.erase(0, line.find_first_not_of(" \t"));  // a room that is built under a condition is indented
    if (!open && line.starts_with(command + "(")) {
      open = true;
      calls.push_back({number, {}});
      line.erase(0, command.size() + 1);
    }
    if (!open) continue;
    const std::size_t close = line.find(')');
    std::istringstream words(line.substr(0, close));
    for (std::string word; words >> word;) calls.back().arguments.push_back(word);
    open = close == std::string::npos;
  }
  return calls;
}

}  // namespace

House::House(const fs::path& root) {
  const fs::path declarations = root / "libvehicle/CMakeLists.txt";
  for (const Call& call : callsOf("vehicle_room", declarations)) {
    Room room;
    room.line = call.line;
    std::set<std::string> unnamed;
    std::set<std::string>* list = &unnamed;
    for (const std::string& word : call.arguments) {
      if (word == "USES") {
        list = &room.uses;
      } else if (word == "PUBLIC") {
        list = &room.publicly;
      } else if (word == "PRIVATE") {
        list = &room.privately;
      } else {
        list->insert(word);
      }
    }
    const std::string name = call.arguments.at(0);
    for (const Call& files : callsOf("vehicle_files", root / "libvehicle" / name / "CMakeLists.txt")) {
      bool header = false;
      for (const std::string& word : files.arguments) {
        if (word == "HEADERS" || word == "SOURCES") {
          header = word == "HEADERS";
          continue;
        }
        room.files.insert(word);
        if (header) room.headers.insert(word);
      }
    }
    rooms_[name] = room;
  }
  if (rooms_.empty()) throw std::runtime_error(declarations.string() + ": declares no room");
}

bool House::sees(const std::string& room, const std::string& library) const {
  const Room& own = rooms_.at(room);
  if (own.privately.contains(library) || own.publicly.contains(library)) return true;
  for (const std::string& below : own.uses) {
    // Downward only, so that a wrong arrow cannot lead in circles.
    if (!rooms_.contains(below) || rooms_.at(below).line >= own.line) continue;
    std::set<std::string> open = {below};
    while (!open.empty()) {
      const Room& next = rooms_.at(*open.begin());
      open.erase(open.begin());
      if (next.publicly.contains(library)) return true;
      for (const std::string& deeper : next.uses) {
        if (rooms_.contains(deeper) && rooms_.at(deeper).line < next.line) open.insert(deeper);
      }
    }
  }
  return false;
}

Violations House::wrongArrows() const {
  Violations found;
  for (const auto& [name, room] : rooms_) {
    const std::string place = "libvehicle/CMakeLists.txt:" + std::to_string(room.line) + ": room " + name + " uses ";
    for (const std::string& target : room.uses) {
      if (!rooms_.contains(target)) {
        found.push_back(place + target + ", which is no room");
      } else if (rooms_.at(target).line >= room.line) {
        found.push_back(place + target + ", which does not stand below it");
      }
    }
  }
  return found;
}

}  // namespace vehicle::test
