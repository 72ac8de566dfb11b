#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libvehicle/definition/train.h"
#include "libvehicle/storage/study_database.h"
#include "libvehicle/study/plan/design_plan.h"
#include "libvehicle/study/study_inputs.h"

namespace vehicle::cli {

/// A study with everything that it names, and the texts of all these files, the study's own first.
struct StudyWork {
  StudyInputs inputs;
  std::optional<Train> train;  // as its file says it, where the study's vehicle is one
  DesignPlan plan;
  std::vector<InputFile> texts;  // named as they lie about the study's file: "study.xml", "../vehicles/coach.xml"
};

/// Problems of all files are told together.
/// @throws InvalidInput
[[nodiscard]] StudyWork readStudyWork(const std::string& file);

/// The same from the files that a database keeps of its study.
/// @throws RunFailed if they cannot be laid out again
[[nodiscard]] StudyWork restoreStudyWork(const StudyRecord& record);

/// Problems whose places are named as in StudyWork::texts, named from here.
[[nodiscard]] ProblemList asSeenFromHere(const ProblemList& problems, const std::string& study_file);

}  // namespace vehicle::cli
