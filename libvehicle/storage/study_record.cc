#include "libvehicle/storage/study_record.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

void requireRoom(const StudyRecord& record) {
  const std::size_t values = record.parameters.size() + record.metrics.size();
  if (values <= kMostStudyValues) return;
  ProblemList problems;
  Place place;
  if (!record.inputs.empty()) {
    const InputFile& study = record.inputs.front();
    const auto root = static_cast<std::ptrdiff_t>(std::min(study.text.find("<study"), study.text.size()));
    place = {study.name, 1 + static_cast<int>(std::count(study.text.begin(), study.text.begin() + root, '\n'))};
  }
  problems.add(place, "",
               fmt::format("the study makes {} columns ({} parameters, {} metrics over all speeds and scenarios), at "
                           "most {} fit in a row",
                           values, record.parameters.size(), record.metrics.size(), kMostStudyValues),
               "ask for fewer metrics or speeds, or make two studies");
  throw InvalidInput(std::move(problems));
}

void DesignBatch::addRow(std::uint64_t id, DesignStatus status, std::span<const double> parameters) {
  if (parameters.size() != parameters_) {
    throw std::invalid_argument(
        fmt::format("DesignBatch: id {} has {} parameters, must have {}", id, parameters.size(), parameters_));
  }
  values_.insert(values_.end(), parameters.begin(), parameters.end());
  rows_.push_back({id, status, std::nullopt, {}});
}

void DesignBatch::setMessage(std::string message) {
  rows_.back().message = messages_.size();
  messages_.push_back(std::move(message));
}

void DesignBatch::add(std::uint64_t id, std::span<const double> parameters, std::span<const double> metrics,
                      std::string message, WarningSet warnings) {
  if (metrics.size() != metrics_) {
    throw std::invalid_argument(
        fmt::format("DesignBatch: id {} has {} metrics, must have {}", id, metrics.size(), metrics_));
  }
  const bool lacks = std::any_of(metrics.begin(), metrics.end(), [](double each) { return std::isnan(each); });
  if (lacks && message.empty()) {
    throw std::invalid_argument(fmt::format("DesignBatch: id {} lacks a value without a message", id));
  }
  addRow(id, DesignStatus::kDone, parameters);
  rows_.back().warnings = warnings;
  values_.insert(values_.end(), metrics.begin(), metrics.end());
  if (!message.empty()) setMessage(std::move(message));
}

void DesignBatch::addFailed(std::uint64_t id, std::span<const double> parameters, std::string message) {
  if (message.empty()) throw std::invalid_argument(fmt::format("DesignBatch: id {} failed without a message", id));
  addRow(id, DesignStatus::kFailed, parameters);
  values_.resize(values_.size() + metrics_, std::numeric_limits<double>::quiet_NaN());
  setMessage(std::move(message));
}

void DesignBatch::clear() {
  rows_.clear();
  values_.clear();
  messages_.clear();
}

std::span<const double> DesignBatch::values(std::size_t row) const {
  const std::size_t width = parameters_ + metrics_;
  return {values_.data() + row * width, width};
}

}  // namespace vehicle
