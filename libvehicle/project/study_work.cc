#include "libvehicle/project/study_work.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>

#include "libvehicle/project/named_files.h"
#include "libvehicle/study/search/search_study.h"
#include "libvehicle/xml/named_file.h"
#include "libvehicle/xml/reader.h"

namespace vehicle {

namespace {

namespace fs = std::filesystem;

/// The texts of a study's files under the names by which they find each other again from the study's own, wherever that
/// lies.
class KeptTexts {
 public:
  KeptTexts(const std::string& study_file, FileSource& files)
      : study_file_(study_file), study_name_(fs::path(study_file).filename().string()), files_(files) {
    keep(study_name_, study_file_);
  }

  /// A file that the study names.
  void keepNamed(const std::string& named) { keep(resolvePath(study_name_, named), resolvePath(study_file_, named)); }
  /// A file that a file named by the study names.
  void keepNamed(const std::string& holder, const std::string& named) {
    keep(resolvePath(resolvePath(study_name_, holder), named), resolvePath(resolvePath(study_file_, holder), named));
  }
  std::vector<InputFile> take() { return std::move(texts_); }

 private:
  void keep(const std::string& name, const std::string& path) {
    const bool is_kept =
        std::any_of(texts_.begin(), texts_.end(), [&](const InputFile& each) { return each.name == name; });
    if (const Outcome<std::string>& text = files_.text(path); text.value && !is_kept) {
      texts_.push_back({name, *text.value});
    }
  }

  std::string study_file_;
  std::string study_name_;
  FileSource& files_;
  std::vector<InputFile> texts_;
};

/// The CSV list of a study, read as far as that goes without the study.
struct ListFile {
  std::string path;  // empty: the study has none
  std::string text;
  ListedColumns columns;
};

ListFile readListFile(const Study& study, FileSource& files, ProblemList& problems) {
  ListFile list;
  if (!study.plan || study.plan->kind != PlanKind::kList || study.plan->file.empty() || !study.plan->origin.knowsAll()) {
    return list;
  }
  list.path = resolvePath(study.plan->origin.file, study.plan->file);
  const Outcome<std::string>& text = files.text(list.path);
  if (!text.value) {
    const Problem& first = text.problems[0];
    problems.add(study.plan->origin, "<study><plan>", "file=\"" + study.plan->file + "\": " + first.message,
                 first.remedy);
    return list;
  }
  list.text = *text.value;
  Outcome<ListedColumns> columns = listedColumns(list.text, list.path);
  problems.append(columns.problems);
  list.columns = std::move(columns.value).value_or(ListedColumns{});
  return list;
}

std::vector<InputFile> textsOf(const std::string& file, const Study& study, const std::optional<Train>& train,
                               FileSource& files) {
  KeptTexts texts(file, files);
  texts.keepNamed(study.vehicle.file);
  if (train) {
    for (const TrainVehicle& each : train->vehicles) texts.keepNamed(study.vehicle.file, each.file);
  }
  for (const FileReference& each : study.scenarios) texts.keepNamed(each.file);
  if (study.plan && study.plan->kind == PlanKind::kList) texts.keepNamed(study.plan->file);
  return texts.take();
}

}  // namespace

Outcome<StudyWork> readStudyWork(const std::string& file, FileSource& files) {
  Settings none;
  return readStudyWork(file, files, none);
}

Outcome<StudyWork> readStudyWork(const std::string& file, FileSource& files, Settings& settings) {
  Outcome<Study> study = draftStudy(file, files);
  if (!study.value) return {std::nullopt, std::move(study.problems)};

  NamedFiles named("study", files, settings);
  std::optional<Vehicle> vehicle = named.vehicle(study.value->vehicle);
  StudyInputs inputs;
  for (const FileReference& each : study.value->scenarios) {
    if (std::optional<Scenario> scenario = named.scenario(each)) inputs.scenarios.push_back(std::move(*scenario));
  }
  ProblemList problems = study.problems;
  problems.append(named.problems());
  const ListFile list = readListFile(*study.value, files, problems);
  // Names can be looked up only in files that are in order.
  if (!vehicle || inputs.scenarios.size() != study.value->scenarios.size()) return {std::nullopt, std::move(problems)};

  if (std::any_of(study.value->varies.begin(), study.value->varies.end(), givesSpeeds)) {
    settings.refuse("speed", "has no effect: the study gives the speeds itself", "omit it, or change its <vary>");
  }
  for (const Scenario& each : inputs.scenarios) problems.append(check(each, *vehicle));
  // What is wrong by itself is reported already; the rest is held against the vehicle all the same.
  const Study sound = soundPartOf(*study.value, study.problems);
  Outcome<BoundStudy> bound = bindStudy(sound, *vehicle, inputs.scenarios, list.columns);
  problems.append(bound.problems);
  problems.sortByPlace();
  if (!problems.empty()) return {std::nullopt, std::move(problems)};

  DesignList designs;
  if (!list.path.empty()) {
    Outcome<DesignList> read = readDesignList(list.text, list.path, *bound.value);
    if (!read.value) return {std::nullopt, std::move(read.problems)};
    designs = std::move(*read.value);
  }
  Outcome<DesignPlan> plan = DesignPlan::of(*study.value, *bound.value, std::move(designs));
  if (!plan.value) return {std::nullopt, std::move(plan.problems)};

  std::optional<Train> train;
  if (!vehicle->units.empty()) train = readTrain(resolvePath(file, study.value->vehicle.file), files).orThrow();
  std::vector<InputFile> texts = textsOf(file, *study.value, train, files);
  for (InputFile& each : keptSettings(settings)) texts.push_back(std::move(each));
  inputs.study = std::move(*study.value);
  inputs.vehicle = std::move(*vehicle);
  inputs.bound = std::move(*bound.value);
  return {StudyWork{std::move(inputs), std::move(train), std::move(*plan.value), std::move(texts), settings.all()}, {}};
}

StudyWork restoreStudyWork(const StudyRecord& record) {
  if (record.inputs.empty()) throw RunFailed("the database holds no study file");
  std::map<std::string, std::string> texts;
  for (const InputFile& each : record.inputs) texts.emplace(each.name, each.text);
  FileSource kept(texts);
  Settings settings = settingsIn(record.inputs);
  StudyWork work = readStudyWork(record.inputs.front().name, kept, settings).orThrow();
  settings.requireRight();
  return work;
}

ProblemList checkBeforeFirstDesign(const StudyWork& work, const std::string& file) {
  ProblemList problems;
  try {
    const StudyEvaluator evaluator(work.inputs);
  } catch (const InvalidInput& wrong) {
    problems.append(wrong.problems());
  } catch (const std::invalid_argument& wrong) {
    problems.add(work.inputs.study.origin, "<study>", wrong.what(), "");
  }
  try {
    const StudyTarget target{{}, false, "", work.texts};
    const std::optional<Search>& search = work.inputs.study.search;
    requireRoom(search ? searchRecordOf(work.plan, *search, target) : recordOf(work.plan, target));
  } catch (const InvalidInput& wrong) {
    problems.append(asSeenFromHere(wrong.problems(), file));
  }
  return problems;
}

StudyOutcome evaluate(const StudyWork& work, const StudyTarget& target, Executor& executor, const StudyWatch& watch) {
  return work.inputs.study.search ? searchStudy(work.inputs, work.plan, target, executor, watch)
                                  : runStudy(work.inputs, work.plan, target, executor, watch);
}

void protectInputs(OutputGuard& guard, const StudyWork& work, const std::string& study_file) {
  guard.protect(study_file, "the study file");
  const fs::path folder = fs::path(study_file).parent_path();
  for (const InputFile& each : work.texts) {
    if (each.name == kSettingsName) continue;  // no file
    guard.protect((folder / each.name).lexically_normal(), "the input file");
  }
}

ProblemList asSeenFromHere(const ProblemList& problems, const std::string& study_file) {
  ProblemList seen;
  for (Problem problem : problems) {
    if (!problem.place.file.empty() && problem.place.file != kSettingsName) {
      problem.place.file = (fs::path(study_file).parent_path() / problem.place.file).lexically_normal().string();
    }
    seen.add(std::move(problem));
  }
  return seen;
}

}  // namespace vehicle
