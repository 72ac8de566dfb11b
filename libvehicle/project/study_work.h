#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libvehicle/definition/train.h"
#include "libvehicle/project/settings.h"
#include "libvehicle/storage/study_record.h"
#include "libvehicle/study/plan/design_plan.h"
#include "libvehicle/study/study_inputs.h"
#include "libvehicle/xml/file_source.h"

namespace vehicle {

/// A study with everything that it names, and the texts of all these files as they were read, the study's own first.
struct StudyWork {
  StudyInputs inputs;
  std::optional<Train> train;  // as its file says it, where the study's vehicle is one
  DesignPlan plan;
  std::vector<InputFile> texts;   // named as they lie about the study's file: "study.xml", "../vehicles/coach.xml";
                                  // the last one may be kSettingsName
  std::vector<Setting> settings;  // that take the place of values of vehicle and scenarios
};

/// Reads a study and all files that it names: vehicle or train, scenarios, list of designs. Problems of all files are
/// reported together.
/// @param settings  are applied to vehicle and scenarios before the study is bound; the caller asks requireRight()
[[nodiscard]] Outcome<StudyWork> readStudyWork(const std::string& file, FileSource& files, Settings& settings);
[[nodiscard]] Outcome<StudyWork> readStudyWork(const std::string& file, FileSource& files);

/// The same from the files that a database keeps of its study; nothing is read from disk.
/// @throws RunFailed if it keeps none, InvalidInput if they cannot be read
[[nodiscard]] StudyWork restoreStudyWork(const StudyRecord& record);

/// What a study in order is refused for before its first design: a steady state over a dip, more metrics than a row of
/// the database holds, a base design that no path can evaluate.
/// Cost: one design on the paths that evaluate several at once, else none.
[[nodiscard]] ProblemList checkBeforeFirstDesign(const StudyWork& work, const std::string& file);

/// Problems whose places are named as in StudyWork::texts, named from here.
[[nodiscard]] ProblemList asSeenFromHere(const ProblemList& problems, const std::string& study_file);

}  // namespace vehicle
