#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "libvehicle/diagnostics/warning_set.h"
#include "libvehicle/study/evaluate/evaluation.h"
#include "libvehicle/study/study_inputs.h"

namespace vehicle {

/// Designs on their way through a path: a row begins with the parameters and gets the metrics after them.
class DesignRows {
 public:
  DesignRows(Batch& batch, std::size_t parameters, std::size_t metrics)
      : batch_(batch),
        parameters_(parameters),
        metrics_(metrics),
        problems_(static_cast<std::size_t>(batch.range.size())),
        missing_(problems_.size()),
        warnings_(problems_.size()) {}

  [[nodiscard]] std::size_t size() const { return problems_.size(); }
  [[nodiscard]] std::span<double> parameters(std::size_t design) { return row(design).first(parameters_); }
  [[nodiscard]] double& metric(std::size_t design, std::size_t metric) { return row(design)[parameters_ + metric]; }
  [[nodiscard]] std::span<double> metrics(std::size_t design) { return row(design).subspan(parameters_); }

  /// The design has no value of this metric, and why; the others stand. The first reason counts.
  void leaveEmpty(std::size_t design, std::size_t metric, std::string why) {
    row(design)[parameters_ + metric] = std::numeric_limits<double>::quiet_NaN();
    missing_[design].try_emplace(metric, std::move(why));
  }
  /// Reasons of the metrics that were left empty, by metric.
  [[nodiscard]] const std::map<std::size_t, std::string>& missing(std::size_t design) const { return missing_[design]; }

  /// The design has no value at all. The first reason counts.
  void fail(std::size_t design, std::string why) {
    if (problems_[design].empty()) problems_[design] = why.empty() ? "failed" : std::move(why);
  }
  /// Says where the design's results left what the model can say.
  void warn(std::size_t design, WarningCode code) { warnings_[design].insert(code); }
  [[nodiscard]] WarningSet warnings(std::size_t design) const { return warnings_[design]; }

  [[nodiscard]] bool failed(std::size_t design) const { return !problems_[design].empty(); }
  [[nodiscard]] const std::string& problem(std::size_t design) const { return problems_[design]; }

 private:
  [[nodiscard]] std::span<double> row(std::size_t design) {
    const std::size_t columns = parameters_ + metrics_;
    return {batch_.values.data() + design * columns, columns};
  }

  Batch& batch_;
  std::size_t parameters_;
  std::size_t metrics_;
  std::vector<std::string> problems_;                        // (designs) empty where nothing is wrong
  std::vector<std::map<std::size_t, std::string>> missing_;  // (designs) metric, why it has no value
  std::vector<WarningSet> warnings_;                         // (designs)
};

/// A metric and where its value goes.
struct MetricPlace {
  Metric metric;
  std::size_t place = 0;  // among the metrics of a row
};

/// A column of a case that some metrics ask for.
struct ColumnRequest {
  std::string column;  // "carbody.az"
  std::vector<MetricPlace> entries;
};

/// What a case is asked for; every column once.
[[nodiscard]] std::vector<ColumnRequest> requestsOf(const BoundStudy& bound, std::size_t study_case);

/// Leaves all metrics of a case empty, for one reason.
void leaveEmpty(const std::vector<ColumnRequest>& requests, std::size_t design, const std::string& why,
                DesignRows& rows);

/// One way to the metrics of result columns. One object a thread.
class Path {
 public:
  virtual ~Path() = default;
  /// Fills the metrics of columns, all cases; designs that are wrong are failed in the rows, values that cannot be are
  /// left empty there.
  virtual void evaluate(DesignRows& rows) = 0;
};

/// How a study is evaluated, chosen once.
struct PathChoice {
  enum class Kind {
    kSteadyEnsemble,  // flat form, closed form, one design a SIMD lane
    kEnsembleRuns,    // flat form, RK4, one design a SIMD lane
    kSteadySingle,    // matrix form, closed form, design by design
    kSingleRuns,      // simulate(), design by design
  };
  Kind kind = Kind::kSingleRuns;
  std::string why_not_flat;  // empty where the flat form is taken
  std::string text;          // a sentence for the user
};

/// @throws InvalidInput  if no path can do what is asked (a steady state over a dip)
[[nodiscard]] PathChoice choosePath(const StudyInputs& inputs);

/// @param inputs  outlives the path
[[nodiscard]] std::unique_ptr<Path> makePath(const StudyInputs& inputs, PathChoice::Kind kind);

/// " at 80 km/h": a case as messages name it; "" where there is only one.
[[nodiscard]] std::string inCase(const StudyCase& study_case);

/// Scenario of a steady state: the rail has always been there.
[[nodiscard]] Scenario steadyScenario(Scenario scenario);

// The four of them, each in its file.
[[nodiscard]] std::unique_ptr<Path> makeSteadyEnsemblePath(const StudyInputs& inputs);
[[nodiscard]] std::unique_ptr<Path> makeEnsembleRunPath(const StudyInputs& inputs);
[[nodiscard]] std::unique_ptr<Path> makeSteadySinglePath(const StudyInputs& inputs);
[[nodiscard]] std::unique_ptr<Path> makeSingleRunPath(const StudyInputs& inputs);

}  // namespace vehicle
