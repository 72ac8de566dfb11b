#include "tests/architecture/results.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace vehicle::test {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::vector<fs::path> resultFiles(const fs::path& root) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root / "benchmarks/results")) {
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

double termOf(std::string_view term, const Results& results) {
  const std::size_t times = term.find(" * ");
  if (times == std::string_view::npos) return results.at(term);
  return std::stod(std::string(term.substr(0, times))) * results.at(term.substr(times + 3));
}

}  // namespace

Results::Results(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    if (!fs::exists(folder)) throw std::invalid_argument(folder.string() + " does not exist");
    for (const auto& entry : fs::directory_iterator(folder)) {
      const std::string name = entry.path().stem().string();
      if (entry.path().extension() != ".csv" || !name.starts_with("bench_")) continue;
      std::vector<Row> rows;
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) rows.push_back(split(line, ','));
      tables_.try_emplace(name.substr(6), std::move(rows));
    }
  }
}

double Results::at(std::string_view reference) const {
  const auto refuse = [&](const std::string& why) {
    return std::invalid_argument("the results have no " + std::string(reference) + ": " + why);
  };
  std::string_view rest = reference;
  std::string column;
  if (const std::size_t at = rest.find('@'); at != std::string_view::npos) {
    column = rest.substr(at + 1);
    rest = rest.substr(0, at);
  }
  std::size_t number = 0;
  if (const std::size_t hash = rest.find('#'); hash != std::string_view::npos) {
    number = static_cast<std::size_t>(std::stoi(std::string(rest.substr(hash + 1))));
    rest = rest.substr(0, hash);
  }
  const std::vector<std::string> keys = split(rest, ':');
  const auto table = tables_.find(keys[0]);
  if (table == tables_.end()) throw refuse("there is no bench_" + keys[0] + ".csv");
  const Row& header = table->second.front();
  const auto columnCalled = [&](const std::string& name) { return std::find(header.begin(), header.end(), name); };
  auto value = columnCalled(column);
  if (column.empty()) value = columnCalled("ns_per_step");
  if (column.empty() && value == header.end()) value = columnCalled("median_ns");
  if (value == header.end()) throw refuse("there is no column " + column);
  std::vector<const Row*> rows;
  for (const Row& row : table->second) {
    const bool begins_so = row.size() >= keys.size() && std::equal(keys.begin() + 1, keys.end(), row.begin());
    if (&row != &header && begins_so) rows.push_back(&row);
  }
  if (rows.empty() || number > rows.size()) throw refuse("there is no such row");
  if (number == 0 && rows.size() > 1) throw refuse("several rows begin so; write #1, #2, ...");
  return std::stod((*rows[number == 0 ? 0 : number - 1])[static_cast<std::size_t>(value - header.begin())]);
}

double valueOf(std::string_view expression, const Results& results) {
  double scale = 1.0;
  static const std::map<std::string, double> units = {{" us", 1e-3}, {" ms", 1e-6}, {" s", 1e-9}, {" %", 1e2}};
  for (const auto& [unit, factor] : units) {
    if (!expression.ends_with(unit)) continue;
    scale = factor;
    expression.remove_suffix(unit.size());
    break;
  }
  const std::size_t over = expression.find(" / ");
  if (over == std::string_view::npos) return scale * termOf(expression, results);
  return scale * termOf(expression.substr(0, over), results) / termOf(expression.substr(over + 3), results);
}

Violations untraceableResults(const fs::path& root) {
  Violations found;
  for (const fs::path& file : resultFiles(root)) {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    const std::vector<std::string> header = split(line, ',');
    const auto commit = std::find(header.begin(), header.end(), "commit");
    const std::string name = fs::relative(file, root).generic_string();
    if (commit == header.end()) {
      found.push_back(name + ":1: no column says of which commit these results are");
      continue;
    }
    const auto column = static_cast<std::size_t>(commit - header.begin());
    std::map<std::string, std::pair<int, int>> wrong;  // what the commit is called: first line, how many
    for (int number = 2; std::getline(stream, line); ++number) {
      const std::vector<std::string> row = split(line, ',');
      const std::string is = row.size() > column ? row[column] : "";
      if (!is.empty() && !is.ends_with("-dirty")) continue;
      ++wrong.try_emplace(is, number, 0).first->second.second;
    }
    for (const auto& [is, where] : wrong) {
      found.push_back(name + ":" + std::to_string(where.first) + ": " + std::to_string(where.second) + " rows are of " +
                      (is.empty() ? "no commit" : "the modified tree " + is) + "; measure them again from a clean one");
    }
  }
  return found;
}

}  // namespace vehicle::test
