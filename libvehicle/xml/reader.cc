#include "libvehicle/xml/reader.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/xml/attribute_value.h"
#include "libvehicle/xml/document.h"
#include "libvehicle/xml/message_text.h"
#include "libvehicle/xml/named_file.h"
#include "libvehicle/xml/part_reader.h"
#include "libvehicle/xml/text_guard.h"

namespace vehicle {

namespace {

std::optional<FileKind> kindNamed(std::string_view root_name) {
  for (const FileKind kind : allFileKinds()) {
    if (schemaOf(kind).name == root_name) return kind;
  }
  return std::nullopt;
}

Problem unknownRoot(const tinyxml2::XMLElement& root, const std::string& file_name) {
  std::vector<std::string> names;
  for (const FileKind kind : allFileKinds()) names.push_back(schemaOf(kind).name);
  const auto nearest = suggestion(root.Value(), names);
  return {{file_name, root.GetLineNum()},
          "",
          fmt::format("the root element <{}> is unknown", shown(root.Value())),
          nearest ? fmt::format("did you mean <{}>?", *nearest)
                  : fmt::format("a file holds one of <{}>", joined(names, ">, <"))};
}

/// The first problems of very many: who sees thousands has opened the wrong file.
ProblemList firstOf(const ProblemList& all) {
  if (all.size() <= kMostProblems + 1) return all;
  ProblemList first;
  for (std::size_t i = 0; i < kMostProblems; ++i) first.add(all[i]);
  first.add(tooMany(all[kMostProblems].place));
  return first;
}

/// What a text says as far as it can be understood, and the problems of its form.
template <class Definition>
Outcome<Definition> formOf(std::string_view text, const std::string& file_name, FileKind kind) {
  Outcome<Definition> draft;
  const Document document = parseDocument(text, file_name);
  draft.problems = document.problems;
  if (document.root == nullptr) return draft;

  const ElementRow& schema = schemaOf(kind);
  const std::optional<FileKind> found = kindNamed(document.root->Value());
  if (!found) {
    draft.problems.add(unknownRoot(*document.root, file_name));
    return draft;
  }
  if (*found != kind) {
    draft.problems.add({{file_name, document.root->GetLineNum()},
                        "",
                        fmt::format("the file holds a <{}>", document.root->Value()),
                        fmt::format("a <{}> is expected here", schema.name)});
    return draft;
  }
  Definition definition;
  PartReader reader(file_name);
  reader.read(*document.root, schema, &definition);
  draft.problems = reader.takeProblems();
  if (reader.isReadable()) draft.value = std::move(definition);
  return draft;
}

template <class Definition>
Outcome<Definition> formOf(const std::string& path, FileKind kind, FileSource& files) {
  const Outcome<std::string>& text = files.text(path);
  if (!text.value) return {std::nullopt, text.problems};
  return formOf<Definition>(*text.value, path, kind);
}

/// The same with the contradictions that check() finds.
template <class Definition>
Outcome<Definition> checked(Outcome<Definition> draft) {
  if (draft.value) draft.problems.append(check(*draft.value));
  draft.problems.sortByPlace();
  draft.problems = firstOf(draft.problems);
  return draft;
}

/// A draft with a value only where there are no problems.
template <class Definition>
Outcome<Definition> finished(Outcome<Definition> draft) {
  if (!draft.problems.empty()) draft.value.reset();
  return draft;
}

template <class Definition>
Outcome<Definition> readDefinition(std::string_view text, const std::string& file_name, FileKind kind) {
  return finished(checked(formOf<Definition>(text, file_name, kind)));
}

template <class Definition>
Outcome<Definition> draftFile(const std::string& path, FileKind kind, FileSource& files) {
  return checked(formOf<Definition>(path, kind, files));
}

/// What the files of a train's vehicles hold; a file that is named twice is reported once.
class TrainFiles {
 public:
  TrainFiles(FileSource& files, ProblemList& problems) : files_(files), problems_(problems) {}

  void fill(Train& train) {
    for (TrainVehicle& each : train.vehicles) {
      if (!each.origin.knows("file")) continue;
      const std::string path = resolvePath(each.origin.file, each.file);
      const auto [found, is_new] = drafts_.try_emplace(path);
      if (is_new) read(each, path, found->second);
      if (found->second.ok()) each.vehicle = *found->second.value;
    }
  }

  /// Each vehicle as far as it could be read.
  std::vector<Vehicle> takeDrafts() {
    std::vector<Vehicle> drafts;
    for (auto& [path, draft] : drafts_) {
      if (draft.value) drafts.push_back(std::move(*draft.value));
    }
    return drafts;
  }

 private:
  void read(const TrainVehicle& each, const std::string& path, Outcome<Vehicle>& draft) {
    const ProblemList missing = checkNamedFile("train", {each.file, each.origin}, {FileKind::kVehicle}, files_);
    problems_.append(missing);
    if (!missing.empty()) return;
    draft = draftFile<Vehicle>(path, FileKind::kVehicle, files_);
    problems_.append(draft.problems);
  }

  FileSource& files_;
  ProblemList& problems_;
  std::map<std::string, Outcome<Vehicle>> drafts_;
};

}  // namespace

Outcome<Vehicle> readVehicleText(std::string_view text, const std::string& file_name) {
  return readDefinition<Vehicle>(text, file_name, FileKind::kVehicle);
}

Outcome<Train> readTrainText(std::string_view text, const std::string& file_name) {
  return readDefinition<Train>(text, file_name, FileKind::kTrain);
}

Outcome<Scenario> readScenarioText(std::string_view text, const std::string& file_name) {
  return readDefinition<Scenario>(text, file_name, FileKind::kScenario);
}

Outcome<Suite> readSuiteText(std::string_view text, const std::string& file_name) {
  return readDefinition<Suite>(text, file_name, FileKind::kSuite);
}

Outcome<Study> readStudyText(std::string_view text, const std::string& file_name) {
  return readDefinition<Study>(text, file_name, FileKind::kStudy);
}

Outcome<Vehicle> readVehicle(const std::string& path, FileSource& files) {
  if (kindOf(path, files).value != FileKind::kTrain) {
    return finished(draftFile<Vehicle>(path, FileKind::kVehicle, files));
  }
  Outcome<Train> train = readTrain(path, files);
  if (!train.value) return {std::nullopt, std::move(train.problems)};
  return {assembled(*train.value), {}};
}

Outcome<Train> readTrain(const std::string& path, FileSource& files) {
  Outcome<Train> draft = formOf<Train>(path, FileKind::kTrain, files);
  if (!draft.value) return draft;
  ProblemList of_vehicles;
  TrainFiles(files, of_vehicles).fill(*draft.value);
  draft = checked(std::move(draft));
  draft.problems.append(of_vehicles);
  draft.problems = firstOf(draft.problems);
  return finished(std::move(draft));
}

Outcome<Scenario> readScenario(const std::string& path, FileSource& files) {
  return finished(draftScenario(path, files));
}

Outcome<Suite> readSuite(const std::string& path, FileSource& files) { return finished(draftSuite(path, files)); }

Outcome<Study> readStudy(const std::string& path, FileSource& files) { return finished(draftStudy(path, files)); }

std::vector<Vehicle> draftVehicles(const std::string& path, FileSource& files) {
  if (kindOf(path, files).value == FileKind::kTrain) {
    Outcome<Train> train = formOf<Train>(path, FileKind::kTrain, files);
    ProblemList ignored;
    TrainFiles of_train(files, ignored);
    if (train.value) of_train.fill(*train.value);
    return of_train.takeDrafts();
  }
  std::vector<Vehicle> drafts;
  Outcome<Vehicle> draft = formOf<Vehicle>(path, FileKind::kVehicle, files);
  if (draft.value) drafts.push_back(std::move(*draft.value));
  return drafts;
}

Outcome<Scenario> draftScenario(const std::string& path, FileSource& files) {
  return draftFile<Scenario>(path, FileKind::kScenario, files);
}

Outcome<Suite> draftSuite(const std::string& path, FileSource& files) {
  return draftFile<Suite>(path, FileKind::kSuite, files);
}

Outcome<Study> draftStudy(const std::string& path, FileSource& files) {
  return draftFile<Study>(path, FileKind::kStudy, files);
}

Outcome<FileKind> kindOf(const std::string& path, FileSource& files) {
  const Outcome<std::string>& text = files.text(path);
  if (!text.value) return {std::nullopt, text.problems};
  Document document = parseDocument(*text.value, path);
  if (document.root == nullptr) return {std::nullopt, std::move(document.problems)};
  Outcome<FileKind> outcome;
  outcome.value = kindNamed(document.root->Value());
  if (!outcome.value) outcome.problems.add(unknownRoot(*document.root, path));
  return outcome;
}

Outcome<Vehicle> readVehicle(const std::string& path) {
  FileSource disk;
  return readVehicle(path, disk);
}

Outcome<Train> readTrain(const std::string& path) {
  FileSource disk;
  return readTrain(path, disk);
}

Outcome<Scenario> readScenario(const std::string& path) {
  FileSource disk;
  return readScenario(path, disk);
}

Outcome<Suite> readSuite(const std::string& path) {
  FileSource disk;
  return readSuite(path, disk);
}

Outcome<Study> readStudy(const std::string& path) {
  FileSource disk;
  return readStudy(path, disk);
}

Outcome<FileKind> kindOf(const std::string& path) {
  FileSource disk;
  return kindOf(path, disk);
}

}  // namespace vehicle
