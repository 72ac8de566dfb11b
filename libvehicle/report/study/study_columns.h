#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "libvehicle/report/document/document.h"
#include "libvehicle/report/document/engineering_units.h"
#include "libvehicle/study/study_inputs.h"
#include "libvehicle/study/summary.h"

namespace vehicle::report {

/// What the tables of a study have in common: columns, units, and how a design, a number or an objective is written.
class StudyColumns {
 public:
  static constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
  using Row = std::vector<Cell>;

  /// @param summary, inputs  outlive the object
  StudyColumns(const StudySummary& summary, const StudyInputs& inputs, Format format);

  /// Whether cells are for people.
  [[nodiscard]] bool formatted() const { return formatted_; }
  [[nodiscard]] const std::vector<MetricColumn>& metrics() const { return columns_; }
  [[nodiscard]] const std::vector<Channel>& parameters() const { return parameters_; }
  [[nodiscard]] const ShownUnit& parameterUnit(std::size_t parameter) const { return parameter_units_[parameter]; }
  [[nodiscard]] const ShownUnit& unitOf(std::size_t column) const { return metric_units_[columns_[column].metric]; }
  [[nodiscard]] const ShownUnit& unitOf(const BoundObjective& objective) const {
    return metric_units_[objective.metric];
  }

  /// A design is called by its name everywhere; other programs get its number in the database too.
  [[nodiscard]] std::vector<TableColumn> head() const;
  void addHead(const JudgedDesign& design, Row& row) const;

  /// "carbody.az.rms, worst of 3"
  [[nodiscard]] std::string nameOf(const BoundObjective& objective) const;
  /// Whether an objective is the worst of several speeds and scenarios.
  [[nodiscard]] bool hasWorst(const BoundObjective& objective) const;

  /// Whether a limit on the column is broken by the value, or by its absence; nothing where there is none.
  [[nodiscard]] std::optional<bool> breaksLimit(std::size_t column, double value) const;
  /// How far a metric is from that of base [%]; nothing where there is no such number.
  [[nodiscard]] std::optional<double> changeIn(std::size_t column, const JudgedDesign& design) const;
  /// A metric with its change and a mark where a limit is broken, as wide with a mark as without.
  [[nodiscard]] std::string textOf(std::size_t column, const JudgedDesign& design) const;

  /// A number, or nothing where it is missing.
  static void addNumber(double value, Row& row);

 private:
  [[nodiscard]] std::size_t casesOf(const BoundObjective& objective) const;
  void chooseUnits(const StudySummary& summary);

  const BoundStudy& bound_;
  std::vector<MetricColumn> columns_;
  std::vector<Channel> parameters_;
  std::vector<ShownUnit> parameter_units_;  // (parameters)
  std::vector<ShownUnit> metric_units_;     // (metrics)
  bool formatted_;
  std::vector<std::vector<std::size_t>> limits_on_;  // (columns)
  const JudgedDesign* base_ = nullptr;
};

}  // namespace vehicle::report
