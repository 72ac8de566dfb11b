#include "libvehicle/result/time_history.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <string>

#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

TimeHistory::TimeHistory(const std::vector<Channel>& channels) {
  columns_.reserve(channels.size() + 1);
  columns_.push_back({"time", "s"});
  columns_.insert(columns_.end(), channels.begin(), channels.end());
  std::vector<std::string> names;
  for (const Channel& column : columns_) names.push_back(column.name);
  std::sort(names.begin(), names.end());
  const auto twin = std::adjacent_find(names.begin(), names.end());
  if (twin != names.end()) throw std::invalid_argument("TimeHistory: two columns are named \"" + *twin + "\"");
}

std::span<double> TimeHistory::append(double time) {
  if (columns_.empty()) throw std::invalid_argument("TimeHistory: append to a history without columns");
  const std::size_t begin = values_.size();
  values_.resize(begin + columns_.size(), 0.0);
  values_[begin] = time;
  return {values_.data() + begin, columns_.size()};
}

std::span<const double> TimeHistory::row(std::size_t sample) const {
  assert(sample < samples());
  return {values_.data() + sample * columns_.size(), columns_.size()};
}

std::vector<double> TimeHistory::column(std::size_t index) const {
  assert(index < columns_.size());
  std::vector<double> values(samples());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = at(i, index);
  return values;
}

void StoredHistory::begin(const std::vector<Channel>& columns, long samples) {
  history_ = TimeHistory(std::vector<Channel>(columns.begin() + 1, columns.end()));
  history_.reserve(static_cast<std::size_t>(samples));
}

void StoredHistory::add(std::span<const double> row) {
  std::copy(row.begin(), row.end(), history_.append(row[0]).begin());
}

std::size_t TimeHistory::indexOf(std::string_view name) const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].name == name) return i;
    names.push_back(columns_[i].name);
  }
  std::string message = "TimeHistory: no column \"" + std::string(name) + "\" among " + std::to_string(names.size());
  if (const auto nearest = nearestName(std::string(name), names)) message += "; did you mean \"" + *nearest + "\"?";
  throw std::invalid_argument(message);
}

}  // namespace vehicle
