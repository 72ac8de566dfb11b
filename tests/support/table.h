#pragma once

#include <charconv>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace vehicle::test {

/// Columns of a plain comma-separated file of numbers with one header line; the tests' own reader, so that
/// certified data does not pass through the code under test.
inline std::map<std::string, std::vector<double>> readTable(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot open " + path);
  std::string line;
  std::getline(file, line);
  if (line.ends_with('\r')) line.pop_back();  // certified files come with either line end
  std::vector<std::string> names;
  for (std::stringstream header(line); std::getline(header, line, ',');) names.push_back(line);
  std::map<std::string, std::vector<double>> table;
  while (std::getline(file, line)) {
    const char* at = line.data();
    const char* const end = at + line.size();
    for (const std::string& name : names) {
      double value = 0.0;
      const auto [rest, error] = std::from_chars(at, end, value);
      if (error != std::errc()) throw std::runtime_error(path + ": not a number in column " + name);
      table[name].push_back(value);
      at = rest == end ? end : rest + 1;
    }
  }
  return table;
}

}  // namespace vehicle::test
