#include "libvehicle/storage/study_changes.h"

#include <algorithm>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/storage/line_diff.h"

namespace vehicle {

namespace {

/// What has changed in one input file since the study began.
void tellChanges(const InputFile& before, const InputFile& now, const std::string& shown, ProblemList& problems) {
  constexpr std::size_t kMost = 20;
  for (const LineChange& change : lineDiff(before.text, now.text)) {
    if (problems.size() >= kMost) return;
    std::string message;
    if (change.was && change.is) {
      message = fmt::format("the line was \"{}\" and is now \"{}\"", *change.was, *change.is);
    } else if (change.is) {
      message = fmt::format("the line \"{}\" is new", *change.is);
    } else {
      message = fmt::format("the line \"{}\" is gone", *change.was);
    }
    problems.add({now.name, static_cast<int>(change.line)}, "",
                 fmt::format("changed since {} was begun: {}", shown, message), "");
  }
}

}  // namespace

void requireSameStudy(const StudyRecord& before, const StudyRecord& now, const std::string& shown) {
  ProblemList problems;
  for (std::size_t i = 0; i < std::max(before.inputs.size(), now.inputs.size()); ++i) {
    if (i >= before.inputs.size()) {
      problems.add({now.inputs[i].name, 0}, "", fmt::format("was no part of the study when {} was begun", shown), "");
    } else if (i >= now.inputs.size()) {
      problems.add({before.inputs[i].name, 0}, "", fmt::format("was a part of the study when {} was begun", shown), "");
    } else if (before.inputs[i].text != now.inputs[i].text) {
      const std::size_t count = problems.size();
      tellChanges(before.inputs[i], now.inputs[i], shown, problems);
      if (problems.size() > count) continue;
      problems.add({now.inputs[i].name, 0}, "", fmt::format("changed since {} was begun: the ends of its lines", shown),
                   "");
    }
  }
  if (!problems.empty()) {
    problems.add({shown, 0}, "", "holds designs of the study as it was",
                 "bring the files back, or write to a new file");
    throw InvalidInput(std::move(problems));
  }
  if (before.program != now.program) {
    throw RunFailed(
        fmt::format("{}: was begun by {}, this is {}: their numbers may differ in the last digits; go on with "
                    "that program, or write to a new file",
                    shown, before.program, now.program));
  }
  if (before.parameters != now.parameters || before.metrics != now.metrics || before.designs != now.designs) {
    throw RunFailed(fmt::format("{}: holds other columns or another number of designs; write to a new file", shown));
  }
}

}  // namespace vehicle
