#include "libvehicle/storage/study_changes.h"

#include <algorithm>

#include <fmt/format.h>

#include "libvehicle/storage/line_diff.h"

namespace vehicle {

namespace {

/// What a file is called may change with the folder that it is named from; the study's own file comes first.
const InputFile* partnerOf(const StudyRecord& from, std::size_t place, const StudyRecord& in) {
  const InputFile& file = from.inputs[place];
  if (place == 0 && !in.inputs.empty()) return &in.inputs.front();
  for (const auto member : {&InputFile::name, &InputFile::text}) {
    const auto found = std::find_if(in.inputs.begin(), in.inputs.end(),
                                    [&](const InputFile& each) { return each.*member == file.*member; });
    if (found != in.inputs.end()) return &*found;
  }
  return nullptr;
}

/// What has changed in one input file since the study began.
void tellChanges(const InputFile& before, const InputFile& now, const std::string& shown, ProblemList& problems) {
  constexpr std::size_t kMost = 20;
  std::size_t count = 0;
  for (const LineChange& change : lineDiff(before.text, now.text)) {
    if (count++ >= kMost) return;
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
  if (count > 0) return;
  problems.add({now.name, 0}, "", fmt::format("changed since {} was begun: the ends of its lines", shown), "");
}

}  // namespace

ProblemList changesOf(const StudyRecord& before, const StudyRecord& now, const std::string& shown) {
  ProblemList problems;
  for (std::size_t i = 0; i < now.inputs.size(); ++i) {
    const InputFile& is = now.inputs[i];
    const InputFile* was = partnerOf(now, i, before);
    if (was == nullptr) {
      problems.add({is.name, 0}, "", fmt::format("was no part of the study when {} was begun", shown), "");
    } else if (was->text != is.text) {
      tellChanges(*was, is, shown, problems);
    }
  }
  for (std::size_t i = 0; i < before.inputs.size(); ++i) {
    if (partnerOf(before, i, now) != nullptr) continue;
    problems.add({before.inputs[i].name, 0}, "", fmt::format("was a part of the study when {} was begun", shown), "");
  }
  if (!problems.empty()) {
    problems.add({shown, 0}, "", "holds designs of the study as it was",
                 "bring the files back, or write to a new file");
  } else if (before.program != now.program) {
    problems.add({shown, 0}, "",
                 fmt::format("was begun by {}, this is {}: their numbers may differ in the last digits", before.program,
                             now.program),
                 "go on with that program, or write to a new file");
  } else if (before.parameters != now.parameters || before.metrics != now.metrics || before.designs != now.designs) {
    problems.add({shown, 0}, "", "holds other columns or another number of designs", "write to a new file");
  }
  return problems;
}

}  // namespace vehicle
