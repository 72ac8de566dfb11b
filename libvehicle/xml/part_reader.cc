#include "libvehicle/xml/part_reader.h"

#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/xml/attribute_value.h"
#include "libvehicle/xml/message_text.h"
#include "libvehicle/xml/text_guard.h"

namespace vehicle {

namespace {

/// Runs of white space become one space, so that a long text may be wrapped and indented in the file.
std::string unwrapped(std::string_view text) {
  std::string line;
  bool gap = false;
  for (const char c : text) {
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
      gap = !line.empty();
      continue;
    }
    if (gap) line += ' ';
    gap = false;
    line += c;
  }
  return line;
}

bool mayStand(const ElementRow& candidate, bool inside_group) { return !inside_group || candidate.in_group; }

/// The element of the table in which `name` may stand, if anywhere: "<track>".
std::optional<std::string> homeOf(std::string_view name, const ElementRow& row) {
  if (row.child(name) != nullptr) return fmt::format("<{}>", row.name);
  for (const ElementRow& child : row.children) {
    if (auto home = homeOf(name, child)) return home;
  }
  return std::nullopt;
}

}  // namespace

void PartReader::report(int line, const std::string& path, std::string message, std::string remedy) {
  if (problems_.size() < kMostProblems) {
    const Problem problem = {{file_, line}, path, std::move(message), std::move(remedy)};
    problems_.add(problem);
  } else if (problems_.size() == kMostProblems) {
    problems_.add(tooMany({file_, line}));
  }
}

void PartReader::read(const tinyxml2::XMLElement& root, const ElementRow& row, void* object) {
  const std::string path = fmt::format("<{}>", row.name);
  *row.origin(object) = {{file_, root.GetLineNum()}};
  // A file of another format means other things by the same words: nothing more can be said about it.
  const AttributeRow* format = row.attribute("format");
  if (const tinyxml2::XMLAttribute* given = root.FindAttribute("format"); given != nullptr) {
    const AttributeReading reading = readAttribute(*format, given->Value());
    if (!reading.message.empty()) {
      report(given->GetLineNum(), path, reading.message, reading.remedy);
      complete_ = false;
      return;
    }
  }
  readAttributes(root, row, object, path);
  readChildren(root, {row, object, path, nullptr, nullptr, ""});
}

void PartReader::readAttributes(const tinyxml2::XMLElement& element, const ElementRow& row, void* object,
                                const std::string& path) {
  std::set<std::string> given;  // also those that were meant by a misspelt one
  std::vector<const tinyxml2::XMLAttribute*> unknown;
  for (const tinyxml2::XMLAttribute* each = element.FirstAttribute(); each != nullptr; each = each->Next()) {
    const AttributeRow* known = row.attribute(each->Name());
    if (known == nullptr) {
      unknown.push_back(each);
      continue;
    }
    given.insert(known->name);
    readOne(*each, *known, row, object, path);
  }
  for (const tinyxml2::XMLAttribute* each : unknown) {
    std::vector<std::string> names;
    for (const AttributeRow& candidate : row.attributes) {
      if (given.count(candidate.name) == 0) names.push_back(candidate.name);
    }
    const auto meant = suggestion(each->Name(), names);
    std::string remedy =
        names.empty() ? "remove it" : fmt::format("what may still stand here: {}", joined(names, ", "));
    if (meant) remedy = fmt::format("did you mean \"{}\"?", *meant);
    report(each->GetLineNum(), path, fmt::format("attribute \"{}\" is unknown", shown(each->Name())),
           std::move(remedy));
    if (!meant) continue;
    given.insert(*meant);
    readOne(*each, *row.attribute(*meant), row, object, path);
  }
  for (const AttributeRow& several : row.attributes) {
    if (several.sets.empty() || given.count(several.name) == 0) continue;
    for (const std::string& name : several.sets) {
      if (given.count(name) != 0) {
        report(element.GetLineNum(), path,
               fmt::format("\"{}\" and \"{}\" are both given, and {} stands for {}", several.name, name, several.name,
                           joined(several.sets, ", ")),
               "remove one of them");
      }
      given.insert(name);
    }
  }
  reportMissing(element, row, object, given, path);
}

void PartReader::readOne(const tinyxml2::XMLAttribute& attribute, const AttributeRow& row,
                         const ElementRow& element_row, void* object, const std::string& path) {
  AttributeReading reading = readAttribute(row, attribute.Value());
  if (!reading.message.empty()) {
    report(attribute.GetLineNum(), path, std::move(reading.message), std::move(reading.remedy));
    // Whoever is called or calls wrongly is missing elsewhere; of an empty text check() would say so again.
    const bool names = row.kind == ValueKind::kName || row.kind == ValueKind::kReference;
    if (names || row.kind == ValueKind::kText) complete_ = false;
  }
  if (row.reserved) {
    element_row.reserved(object)->push_back({row.name, attribute.Value()});
  } else if (row.set != nullptr) {
    row.set(object, reading.value);
  }
}

void PartReader::reportMissing(const tinyxml2::XMLElement& element, const ElementRow& row, void* object,
                               const std::set<std::string>& given, const std::string& path) {
  for (const AttributeRow& each : row.attributes) {
    if (!each.required || given.count(each.name) != 0) continue;
    report(element.GetLineNum(), path, fmt::format("attribute \"{}\" is missing", each.name),
           fmt::format("write e.g. {}", exampleOf(each, row)));
    if (each.kind == ValueKind::kFormat) continue;
    const Value instead = standInFor(each);
    if (std::holds_alternative<std::monostate>(instead)) {
      complete_ = false;
    } else {
      each.set(object, instead);
    }
  }
}

const ElementRow* PartReader::rowFor(const tinyxml2::XMLElement& child, const Scope& scope) {
  const bool inside_group = scope.holder != nullptr;
  const ElementRow& family = inside_group ? *scope.holder : scope.row;
  const std::string name = child.Value();
  if (const ElementRow* found = family.child(name)) {
    if (mayStand(*found, inside_group)) return found;
    report(child.GetLineNum(), scope.path, fmt::format("<{}> stands inside <{}>", name, scope.row.name),
           fmt::format("close <{}> before it", scope.row.name));
    complete_ = false;
    return nullptr;
  }
  std::vector<std::string> names;
  for (const ElementRow& candidate : family.children) {
    if (mayStand(candidate, inside_group)) names.push_back(candidate.name);
  }
  const auto meant = suggestion(name, names);
  std::string remedy = "nothing may stand here";
  if (!names.empty()) remedy = fmt::format("what may stand here: <{}>", joined(names, ">, <"));
  if (meant) remedy = fmt::format("did you mean <{}>?", *meant);
  std::string message = fmt::format("element <{}> is unknown", shown(name));
  for (const FileKind kind : allFileKinds()) {
    if (meant || name.size() > 64) break;
    if (const auto home = homeOf(name, schemaOf(kind))) {
      message = fmt::format("element <{}> has no meaning here", name);
      remedy = fmt::format("it may stand in {}", *home);
      break;
    }
  }
  report(child.GetLineNum(), scope.path, std::move(message), std::move(remedy));
  if (meant) return family.child(*meant);
  complete_ = false;
  return nullptr;
}

void PartReader::readChildren(const tinyxml2::XMLElement& element, const Scope& scope) {
  std::map<std::string, int> first_line;
  for (const tinyxml2::XMLNode* node = element.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToText() != nullptr) {
      report(node->GetLineNum(), scope.path,
             fmt::format("the text \"{}\" stands here", shown(unwrapped(node->Value()))),
             "values are attributes; only <title> and <source> hold text");
      continue;
    }
    const tinyxml2::XMLElement* child = node->ToElement();
    if (child == nullptr) continue;
    const ElementRow* row = rowFor(*child, scope);
    if (row == nullptr) continue;
    const auto [first, is_first] = first_line.emplace(row->name, child->GetLineNum());
    if (!is_first && !row->many) {
      report(child->GetLineNum(), scope.path,
             fmt::format("<{}> stands a second time, first in line {}", row->name, first->second),
             "remove one of them");
      continue;
    }
    readChild(*child, *row, scope);
  }
  for (const ElementRow& row : scope.row.children) {
    if (row.required && first_line.count(row.name) == 0) {
      report(element.GetLineNum(), scope.path, fmt::format("element <{}> is missing", row.name),
             fmt::format("write e.g. {}", row.example));
      complete_ = false;
    }
  }
}

void PartReader::readChild(const tinyxml2::XMLElement& child, const ElementRow& row, const Scope& scope) {
  const std::string path = fmt::format("{}<{}>", scope.path, row.name);
  void* parent = scope.holder != nullptr ? scope.holder_object : scope.object;
  if (row.text != nullptr) {
    readText(child, row, *row.text(parent), path);
    return;
  }
  void* object = row.add(parent);
  *row.origin(object) = {{file_, child.GetLineNum()}};
  readAttributes(child, row, object, path);
  if (row.group != nullptr) *row.group(object) = scope.group;
  if (row.is_group) {
    const Value name = row.attribute("name")->get(object);
    readChildren(child, {row, object, path, &scope.row, scope.object, std::get<std::string>(name)});
  } else {
    readChildren(child, {row, object, path, nullptr, nullptr, ""});
  }
}

void PartReader::readText(const tinyxml2::XMLElement& element, const ElementRow& row, std::string& text,
                          const std::string& path) {
  readAttributes(element, row, nullptr, path);
  std::string all;
  for (const tinyxml2::XMLNode* node = element.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToText() != nullptr) {
      all += node->Value();
    } else if (node->ToElement() != nullptr) {
      report(node->GetLineNum(), path, fmt::format("element <{}> stands inside a text", shown(node->Value())),
             "write text alone");
    }
  }
  text = unwrapped(all);
}

}  // namespace vehicle
