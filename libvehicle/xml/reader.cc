#include "libvehicle/xml/reader.h"

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

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

/// Problems of the files that a suite names, told at the place that names them.
void checkReferences(const std::vector<FileReference>& references, FileKind kind, ProblemList& problems) {
  const std::string& element = schemaOf(kind).name;
  for (const FileReference& reference : references) {
    const std::string path = resolvePath(reference.origin.file, reference.file);
    const Outcome<FileKind> found = kindOf(path);
    const std::string written = fmt::format("file=\"{}\"", shown(reference.file));
    if (!found.value) {
      const Problem& first = found.problems[0];
      problems.add({reference.origin, fmt::format("<suite><{}>", element),
                    fmt::format("{}: {}", written, first.message), first.remedy});
    } else if (*found.value != kind) {
      problems.add({reference.origin, fmt::format("<suite><{}>", element),
                    fmt::format("{} holds a <{}>", written, schemaOf(*found.value).name),
                    fmt::format("a <{}> is expected here", element)});
    }
  }
}

}  // namespace

Outcome<Vehicle> readVehicleText(std::string_view text, const std::string& file_name) {
  return readDefinition<Vehicle>(text, file_name, FileKind::kVehicle);
}

Outcome<Scenario> readScenarioText(std::string_view text, const std::string& file_name) {
  return readDefinition<Scenario>(text, file_name, FileKind::kScenario);
}

Outcome<Suite> readSuiteText(std::string_view text, const std::string& file_name) {
  return readDefinition<Suite>(text, file_name, FileKind::kSuite);
}

Outcome<Vehicle> readVehicle(const std::string& path) { return readFile<Vehicle>(path, FileKind::kVehicle); }

Outcome<Scenario> readScenario(const std::string& path) { return readFile<Scenario>(path, FileKind::kScenario); }

Outcome<Suite> readSuite(const std::string& path) {
  Outcome<Suite> outcome = readFile<Suite>(path, FileKind::kSuite);
  if (!outcome.value) return outcome;
  checkReferences(outcome.value->vehicles, FileKind::kVehicle, outcome.problems);
  checkReferences(outcome.value->scenarios, FileKind::kScenario, outcome.problems);
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
    case FileKind::kScenario:
      return readScenario(path).problems;
    case FileKind::kSuite:
      return readSuite(path).problems;
  }
  return {};
}

std::string resolvePath(const std::string& naming_file, const std::string& named) {
  return (std::filesystem::path(naming_file).parent_path() / named).lexically_normal().string();
}

}  // namespace vehicle
