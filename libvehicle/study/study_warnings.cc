#include "libvehicle/study/study_warnings.h"

#include <bit>
#include <cctype>
#include <string>

#include <fmt/format.h>

#include "libvehicle/simulate/file_warnings.h"
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

Warnings vehicleWarnings(const StudyInputs& inputs) {
  if (inputs.scenarios.empty()) return {};
  try {
    return fileWarnings(compile(inputs.vehicle, inputs.scenarios.front().gravity));
  } catch (const InvalidInput&) {
    return {};  // it has no rest position: its designs say why
  }
}

/// "A wheel load fell below 0: ... . From ..." as the middle of a line: its first sentence, begun in lower case.
std::string clauseOf(WarningCode code) {
  for (const WarningKind& each : warningKinds()) {
    if (each.code != code) continue;
    std::string text(each.sentence.substr(0, each.sentence.find(". ")));
    if (text.ends_with('.')) text.pop_back();
    text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
    return text;
  }
  return "";
}

Warning warned(const StudyInputs& inputs, const WarnedDesigns& designs, std::uint64_t stored) {
  Warning warning;
  warning.code = designs.code;
  warning.place = inputs.study.origin;
  warning.subject = "<study>";
  warning.message = fmt::format("{} of {} designs, the first is {}: {}", designs.designs, stored, designs.first,
                                clauseOf(designs.code));
  warning.remedy = "the column warnings of --export names them all";
  warning.value = static_cast<double>(designs.designs);
  return warning;
}

}  // namespace

Warnings warningsBefore(const StudyInputs& inputs) {
  Warnings warnings = vehicleWarnings(inputs);
  const Warnings modes = unknownModes(inputs);
  warnings.insert(warnings.end(), modes.begin(), modes.end());
  if (isSaltelli(inputs.study)) {
    const Plan& plan = *inputs.study.plan;
    if (!std::has_single_bit(static_cast<unsigned>(plan.size.value_or(1)))) warnings.push_back(sampleSize(plan));
  }
  return warnings;
}

Warnings warningsAfter(const StudyInputs& inputs, const StudySummary& summary) {
  Warnings warnings;
  for (const WarnedDesigns& each : summary.warnings) warnings.push_back(warned(inputs, each, summary.stored));
  if (!isSaltelli(inputs.study) || summary.stored < summary.designs) return warnings;
  for (const Influence& each : summary.influences) {
    if (each.indices.indices.empty()) warnings.push_back(noIndex(*inputs.study.plan, each));
  }
  return warnings;
}

}  // namespace vehicle
