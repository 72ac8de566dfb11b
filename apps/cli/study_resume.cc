#include "apps/cli/study_resume.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/storage/study_changes.h"
#include "libvehicle/storage/study_database.h"
#include "libvehicle/xml/reader.h"

namespace vehicle::cli {
namespace {

/// "" where the text is no study that this program reads.
std::string nameOfStudyIn(const StudyRecord& record) {
  if (record.inputs.empty()) return {};
  const Outcome<Study> study = readStudyText(record.inputs.front().text, record.inputs.front().name);
  return study.value ? study.value->name : std::string();
}

}  // namespace

void requireOwnDatabase(const std::string& database, const std::string& study, const StudyWork& work) {
  StudyRecord before = StudyDatabase::read(database).record();
  const std::string& name = work.inputs.study.name;
  const std::string stored = nameOfStudyIn(before);
  ProblemList problems;
  if (!stored.empty() && stored != name) {
    problems.add({database, 0}, "",
                 fmt::format("holds the study \"{}\", and {} is the study \"{}\"", stored, study, name),
                 "name the database of this study, or another file for a new one");
    throw InvalidInput(std::move(problems));
  }
  // The columns follow from files and program.
  StudyRecord now = before;
  now.inputs = work.texts;
  now.program = kProgram;
  const std::filesystem::path folder = std::filesystem::path(study).parent_path();
  for (StudyRecord* each : {&before, &now}) {
    for (InputFile& file : each->inputs) {
      if (file.name != kSettingsName) file.name = (folder / file.name).lexically_normal().string();
    }
  }
  problems = changesOf(before, now, database);
  if (!problems.empty()) throw InvalidInput(std::move(problems));
}

StudyWork restoredFrom(const StudyRecord& record, const std::string& database) {
  try {
    return restoreStudyWork(record);
  } catch (const InvalidInput& wrong) {
    ProblemList problems;
    for (Problem each : wrong.problems()) {
      each.place.file = fmt::format("{} ({})", database, each.place.file);
      problems.add(std::move(each));
    }
    throw InvalidInput(std::move(problems));
  }
}

}  // namespace vehicle::cli
