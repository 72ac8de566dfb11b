#pragma once

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "libvehicle/study/evaluate/study_evaluator.h"
#include "libvehicle/study/execute/executor.h"
#include "libvehicle/study/study_inputs.h"
#include "tests/support/studies.h"
#include "tests/support/vehicles.h"

// Studies made by hand, and the rows of their designs.
namespace vehicle::test {

inline Study studyOf(std::vector<Vary> varies, const std::vector<std::string>& metrics) {
  Study made;
  made.name = "by-hand";
  made.vehicle.file = "vehicle.xml";
  made.scenarios = {{"scenario.xml", {}}};
  made.varies = std::move(varies);
  for (const std::string& each : metrics) made.metrics.push_back({each, {}});
  return made;
}

inline StudyInputs inputsOf(Study study, Vehicle vehicle, std::vector<Scenario> scenarios) {
  StudyInputs made;
  made.bound = vehicle::bindStudy(study, vehicle, scenarios).orThrow();
  made.study = std::move(study);
  made.vehicle = std::move(vehicle);
  made.scenarios = std::move(scenarios);
  return made;
}

/// What came out of some designs.
struct Answers {
  std::vector<std::vector<double>> metrics;      // (designs x metrics)
  std::map<std::int64_t, std::string> problems;  // of the designs that failed
  std::map<std::int64_t, std::string> gaps;      // why others lack values
  std::map<std::int64_t, std::string> warnings;  // words of those that have some
};

/// Evaluates designs given by their parameter values.
inline Answers answersOf(const StudyInputs& inputs, const std::vector<std::vector<double>>& designs, int threads = 1) {
  const StudyEvaluator evaluator(inputs);
  const std::size_t parameters = inputs.bound.parameters.size();
  Workload workload;
  workload.ranges = {{0, static_cast<std::int64_t>(designs.size())}};
  for (const std::vector<double>& each : designs) workload.given.insert(workload.given.end(), each.begin(), each.end());
  Answers answers;
  answers.metrics.resize(designs.size());
  ThreadExecutor(threads).run(evaluator, workload, [&](Batch& batch) {
    for (std::int64_t design = batch.range.first; design < batch.range.end; ++design) {
      const std::span<double> row = batch.row(design, evaluator.columns()).subspan(parameters);
      answers.metrics[static_cast<std::size_t>(design)].assign(row.begin(), row.end());
    }
    for (const DesignFailure& each : batch.failures) answers.problems[each.design] = each.message;
    for (const DesignGap& each : batch.gaps) answers.gaps[each.design] = each.message;
    for (const DesignWarnings& each : batch.warnings) answers.warnings[each.design] = each.warnings.words();
  });
  return answers;
}

/// Metrics of a path of our choice.
inline Answers answersBy(const StudyInputs& inputs, PathChoice::Kind kind,
                         const std::vector<std::vector<double>>& designs) {
  const std::size_t parameters = inputs.bound.parameters.size();
  const std::size_t metrics = metricColumns(inputs.bound).size();
  Batch batch;
  batch.reset({0, static_cast<std::int64_t>(designs.size())}, parameters + metrics);
  DesignRows rows(batch, parameters, metrics);
  for (std::size_t i = 0; i < designs.size(); ++i)
    std::copy(designs[i].begin(), designs[i].end(), rows.parameters(i).begin());
  makePath(inputs, kind)->evaluate(rows);
  Answers answers;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    answers.metrics.emplace_back(rows.metrics(i).begin(), rows.metrics(i).end());
    if (rows.failed(i)) answers.problems[static_cast<std::int64_t>(i)] = rows.problem(i);
  }
  return answers;
}

}  // namespace vehicle::test
