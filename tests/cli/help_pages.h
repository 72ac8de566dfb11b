#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/cli/studies.h"

// What the pages of --help say, so that a table of a test can be held against them.
namespace vehicle::test {

inline std::vector<std::string> commands() {
  std::vector<std::string> names;
  for (const std::string& line : linesOf(runVehicle({"--help"}).out)) {
    if (line.starts_with("  ") && line[2] != ' ' && line[2] != '-')
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

/// Options of a command with the word for their value, "" of a flag.
inline std::map<std::string, std::string> optionsOf(const std::string& command) {
  std::map<std::string, std::string> options;
  for (const std::string& line : linesOf(runVehicle({command, "--help"}).out)) {
    if (!line.starts_with("  --")) continue;
    const std::size_t end = line.find(' ', 2);
    const std::size_t word = end + 1;
    const bool has_value = line[word] != ' ';
    options[line.substr(2, end - 2)] = has_value ? line.substr(word, line.find(' ', word) - word) : "";
  }
  return options;
}

}  // namespace vehicle::test
