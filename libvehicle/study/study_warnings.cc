#include "libvehicle/study/study_warnings.h"

#include <bit>

#include <fmt/format.h>

#include "libvehicle/study/evaluate/mode_metrics.h"

namespace vehicle {

namespace {

bool isSaltelli(const Study& study) { return study.plan && study.plan->kind == PlanKind::kSaltelli && !study.search; }

Warning sampleSize(const Plan& plan) {
  const auto size = static_cast<unsigned>(plan.size.value_or(0));
  Warning warning;
  warning.code = WarningCode::kSampleSize;
  warning.place = plan.origin;
  warning.subject = "<study><plan>";
  warning.message = fmt::format(
      "size=\"{}\" is no power of two: the points of the plan are not balanced, its indices converge more slowly",
      size);
  warning.remedy = fmt::format("take {} or {}", std::bit_floor(size), std::bit_ceil(size));
  warning.value = size;
  return warning;
}

Warning noIndex(const Plan& plan, const Influence& influence) {
  const SensitivityResult& indices = influence.indices;
  Warning warning;
  warning.code = WarningCode::kNoIndex;
  warning.place = plan.origin;
  warning.subject = influence.output;
  const std::size_t blocks = indices.blocks + indices.left_out;
  if (indices.blocks >= 2) {
    warning.message = fmt::format("no sensitivity index can be given: it is {:.6g} in every design", indices.mean);
    warning.remedy = "vary what it depends on, or leave it out";
    warning.value = indices.mean;
  } else if (indices.left_out > 0) {
    warning.message = fmt::format(
        "no sensitivity index can be given: designs without a value break {} of {} blocks of the plan, two must be "
        "whole",
        indices.left_out, blocks);
    warning.remedy = "vary less, so that every design has a value";
  } else {
    warning.message = fmt::format("no sensitivity index can be given: the plan has {} block, two are needed", blocks);
    warning.remedy = "take a larger size";
  }
  return warning;
}

}  // namespace

Warnings warningsBefore(const StudyInputs& inputs) {
  Warnings warnings = unknownModes(inputs);
  if (isSaltelli(inputs.study)) {
    const Plan& plan = *inputs.study.plan;
    if (!std::has_single_bit(static_cast<unsigned>(plan.size.value_or(1)))) warnings.push_back(sampleSize(plan));
  }
  return warnings;
}

Warnings warningsAfter(const StudyInputs& inputs, const StudySummary& summary) {
  Warnings warnings;
  if (!isSaltelli(inputs.study) || summary.stored < summary.designs) return warnings;
  for (const Influence& each : summary.influences) {
    if (each.indices.indices.empty()) warnings.push_back(noIndex(*inputs.study.plan, each));
  }
  return warnings;
}

}  // namespace vehicle
