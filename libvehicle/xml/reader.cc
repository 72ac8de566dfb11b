#include "libvehicle/xml/reader.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/definition/bound_study.h"
#include "libvehicle/xml/attribute_value.h"
#include "libvehicle/xml/document.h"
#include "libvehicle/xml/message_text.h"
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

template <class Definition>
Outcome<Definition> readDefinition(std::string_view text, const std::string& file_name, FileKind kind) {
  Outcome<Definition> outcome;
  const Document document = parseDocument(text, file_name);
  outcome.problems = document.problems;
  if (document.root == nullptr) return outcome;

  const ElementRow& schema = schemaOf(kind);
  const std::optional<FileKind> found = kindNamed(document.root->Value());
  if (!found) {
    outcome.problems.add(unknownRoot(*document.root, file_name));
    return outcome;
  }
  if (*found != kind) {
    outcome.problems.add({{file_name, document.root->GetLineNum()},
                          "",
                          fmt::format("the file holds a <{}>", document.root->Value()),
                          fmt::format("a <{}> is expected here", schema.name)});
    return outcome;
  }

  Definition definition;
  PartReader reader(file_name);
  reader.read(*document.root, schema, &definition);
  outcome.problems = reader.takeProblems();
  if (reader.isComplete()) outcome.problems.append(check(definition));
  outcome.problems.sortByPlace();
  outcome.problems = firstOf(outcome.problems);
  if (outcome.problems.empty()) outcome.value = std::move(definition);
  return outcome;
}

template <class Definition>
Outcome<Definition> readFile(const std::string& path, FileKind kind) {
  Outcome<std::string> text = readText(path);
  if (!text.value) return {std::nullopt, std::move(text.problems)};
  return readDefinition<Definition>(*text.value, path, kind);
}

/// Problems of the files that a suite, study or train names, told at the place that names them.
/// @param kinds  what the files may be; elements are called after the first
void checkReferences(const std::string& root, const std::vector<FileReference>& references,
                     std::initializer_list<FileKind> kinds, ProblemList& problems) {
  const std::string& element = schemaOf(*kinds.begin()).name;
  for (const FileReference& reference : references) {
    const std::string path = resolvePath(reference.origin.file, reference.file);
    const Outcome<FileKind> found = kindOf(path);
    const std::string written = fmt::format("file=\"{}\"", shown(reference.file));
    if (!found.value) {
      const Problem& first = found.problems[0];
      problems.add({reference.origin, fmt::format("<{}><{}>", root, element),
                    fmt::format("{}: {}", written, first.message), first.remedy});
    } else if (std::find(kinds.begin(), kinds.end(), *found.value) == kinds.end()) {
      problems.add({reference.origin, fmt::format("<{}><{}>", root, element),
                    fmt::format("{} holds a <{}>", written, schemaOf(*found.value).name),
                    fmt::format("a <{}> is expected here", element)});
    }
  }
}

/// Fills in what the files of a train's vehicles hold; a file that is named twice is read and told once.
void readVehiclesOf(Train& train, ProblemList& problems) {
  std::map<std::string, Outcome<Vehicle>> known;
  for (TrainVehicle& each : train.vehicles) {
    const std::string path = resolvePath(each.origin.file, each.file);
    auto found = known.find(path);
    if (found == known.end()) {
      const std::size_t before = problems.size();
      checkReferences("train", {{each.file, each.origin}}, {FileKind::kVehicle}, problems);
      if (problems.size() > before) continue;
      found = known.emplace(path, readFile<Vehicle>(path, FileKind::kVehicle)).first;
      problems.append(found->second.problems);
    }
    if (found->second.value) each.vehicle = *found->second.value;
  }
}

/// What a study names: of vehicles also trains.
template <class Definition>
Outcome<Definition> readAsNamed(const std::string& path, FileKind kind) {
  if constexpr (std::is_same_v<Definition, Vehicle>) {
    return readVehicle(path);
  } else {
    return readFile<Definition>(path, kind);
  }
}

/// A file that a study names, read; its first problem is told where the study names it.
template <class Definition>
std::optional<Definition> readNamed(const FileReference& reference, FileKind kind, ProblemList& problems) {
  const std::size_t before = problems.size();
  if (kind == FileKind::kVehicle) {
    checkReferences("study", {reference}, {kind, FileKind::kTrain}, problems);
  } else {
    checkReferences("study", {reference}, {kind}, problems);
  }
  if (problems.size() > before) return std::nullopt;
  Outcome<Definition> read = readAsNamed<Definition>(resolvePath(reference.origin.file, reference.file), kind);
  if (read.value) return std::move(read.value);
  problems.add({reference.origin, fmt::format("<study><{}>", schemaOf(kind).name),
                fmt::format("file=\"{}\" has problems: {}", shown(reference.file), read.problems[0].text()),
                "mend it first"});
  return std::nullopt;
}

/// The study held against its vehicle and scenarios, where those are in order.
void checkStudyFiles(const Study& study, ProblemList& problems) {
  const std::optional<Vehicle> vehicle = readNamed<Vehicle>(study.vehicle, FileKind::kVehicle, problems);
  std::vector<Scenario> scenarios;
  for (const FileReference& each : study.scenarios) {
    std::optional<Scenario> scenario = readNamed<Scenario>(each, FileKind::kScenario, problems);
    if (!scenario) continue;
    if (vehicle) problems.append(check(*scenario, *vehicle));
    scenarios.push_back(std::move(*scenario));
  }
  if (study.plan && study.plan->kind == PlanKind::kList) {
    const std::string list = resolvePath(study.plan->origin.file, study.plan->file);
    if (!std::filesystem::exists(list)) {
      problems.add({study.plan->origin, "<study><plan>",
                    fmt::format("file=\"{}\" is not there", shown(study.plan->file)),
                    "paths count from the folder of the study"});
    }
  }
  if (!vehicle || scenarios.size() != study.scenarios.size()) return;
  problems.append(bindStudy(study, *vehicle, scenarios).problems);
}

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

Outcome<Vehicle> readVehicle(const std::string& path) {
  if (kindOf(path).value != FileKind::kTrain) return readFile<Vehicle>(path, FileKind::kVehicle);
  Outcome<Train> train = readTrain(path);
  if (!train.value) return {std::nullopt, std::move(train.problems)};
  return {assembled(*train.value), {}};
}

Outcome<Train> readTrain(const std::string& path) {
  Outcome<Train> outcome = readFile<Train>(path, FileKind::kTrain);
  if (!outcome.value) return outcome;
  readVehiclesOf(*outcome.value, outcome.problems);
  if (outcome.problems.empty()) outcome.problems = check(*outcome.value);
  outcome.problems = firstOf(outcome.problems);
  if (!outcome.problems.empty()) outcome.value.reset();
  return outcome;
}

Outcome<Scenario> readScenario(const std::string& path) { return readFile<Scenario>(path, FileKind::kScenario); }

Outcome<Suite> readSuite(const std::string& path) {
  Outcome<Suite> outcome = readFile<Suite>(path, FileKind::kSuite);
  if (!outcome.value) return outcome;
  checkReferences("suite", outcome.value->vehicles, {FileKind::kVehicle, FileKind::kTrain}, outcome.problems);
  checkReferences("suite", outcome.value->scenarios, {FileKind::kScenario}, outcome.problems);
  outcome.problems.sortByPlace();
  if (!outcome.problems.empty()) outcome.value.reset();
  return outcome;
}

Outcome<Study> readStudy(const std::string& path) {
  Outcome<Study> outcome = readFile<Study>(path, FileKind::kStudy);
  if (!outcome.value) return outcome;
  checkStudyFiles(*outcome.value, outcome.problems);
  outcome.problems.sortByPlace();
  if (!outcome.problems.empty()) outcome.value.reset();
  return outcome;
}

Outcome<FileKind> kindOf(const std::string& path) {
  Outcome<std::string> text = readText(path);
  if (!text.value) return {std::nullopt, std::move(text.problems)};
  Document document = parseDocument(*text.value, path);
  if (document.root == nullptr) return {std::nullopt, std::move(document.problems)};
  Outcome<FileKind> outcome;
  outcome.value = kindNamed(document.root->Value());
  if (!outcome.value) outcome.problems.add(unknownRoot(*document.root, path));
  return outcome;
}

ProblemList checkFile(const std::string& path) {
  const Outcome<FileKind> kind = kindOf(path);
  if (!kind.value) return kind.problems;
  switch (*kind.value) {
    case FileKind::kVehicle:
      return readVehicle(path).problems;
    case FileKind::kTrain:
      return readTrain(path).problems;
    case FileKind::kScenario:
      return readScenario(path).problems;
    case FileKind::kSuite:
      return readSuite(path).problems;
    case FileKind::kStudy:
      return readStudy(path).problems;
  }
  return {};
}

std::string resolvePath(const std::string& naming_file, const std::string& named) {
  return (std::filesystem::path(naming_file).parent_path() / named).lexically_normal().string();
}

}  // namespace vehicle
