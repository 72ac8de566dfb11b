#include "libvehicle/xml/part_reader.h"

#include <algorithm>
#include <map>
#include <memory>
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

/// What editors write so that they find the schema of a file: nothing that the file says itself.
bool isSchemaReference(std::string_view attribute) {
  return attribute == "xmlns:xsi" || attribute == "xsi:noNamespaceSchemaLocation" ||
         attribute == "xsi:schemaLocation";
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
      readable_ = false;
      return;
    }
  }
  PartText text = readAttributes(root, row, object, path);
  readChildren(root, {row, object, path, nullptr, nullptr, ""});
  text.strange_words = std::move(strange_words_);
  text.has_strange = has_strange_;
  row.origin(object)->text = std::make_shared<const PartText>(std::move(text));
}

PartText PartReader::readAttributes(const tinyxml2::XMLElement& element, const ElementRow& row, void* object,
                                    const std::string& path) {
  Attributes of{element, row, object, path};
  std::vector<const tinyxml2::XMLAttribute*> unknown;
  for (const tinyxml2::XMLAttribute* each = element.FirstAttribute(); each != nullptr; each = each->Next()) {
    if (isSchemaReference(each->Name()) && element.Parent()->ToDocument() != nullptr) continue;
    const AttributeRow* known = row.attribute(each->Name());
    if (known == nullptr) {
      unknown.push_back(each);
    } else {
      readOne(*each, *known, of);
    }
  }
  bool something_strange = false;
  for (const tinyxml2::XMLAttribute* each : unknown) {
    if (!readMisspelt(*each, of)) something_strange = true;
  }
  readStandingFor(of);
  addMissing(something_strange, of);
  of.text.whole = std::all_of(of.text.attributes.begin(), of.text.attributes.end(),
                              [](const AttributeText& each) { return each.known; });
  return std::move(of.text);
}

void PartReader::readOne(const tinyxml2::XMLAttribute& attribute, const AttributeRow& row, Attributes& of) {
  of.given.emplace(row.name);
  AttributeReading reading = readAttribute(row, attribute.Value());
  const bool known = reading.message.empty();
  if (!known) report(attribute.GetLineNum(), of.path, std::move(reading.message), std::move(reading.remedy));
  of.text.attributes.push_back(
      {std::string(row.name), attribute.Name(), attribute.Value(), attribute.GetLineNum(), true, known});
  if (row.reserved) {
    of.row.reserved(of.object)->push_back({std::string(row.name), attribute.Value()});
  } else if (row.set != nullptr) {
    row.set(of.object, reading.value);
  }
}

/// Reads an attribute that the table does not have as the one that is probably meant: of a like name, or a missing one
/// that the value fits. False: it stays open.
bool PartReader::readMisspelt(const tinyxml2::XMLAttribute& attribute, Attributes& of) {
  std::vector<std::string> names;
  const AttributeRow* fitting = nullptr;
  for (const AttributeRow& candidate : of.row.attributes) {
    if (of.given.contains(candidate.name)) continue;
    names.emplace_back(candidate.name);
    const bool fits = candidate.required && readAttribute(candidate, attribute.Value()).message.empty();
    if (fits && fitting == nullptr) fitting = &candidate;
  }
  const auto like = suggestion(attribute.Name(), names);
  const AttributeRow* meant = like ? of.row.attribute(*like) : fitting;
  std::string remedy = names.empty() ? "remove it" : fmt::format("what may still stand here: {}", joined(names, ", "));
  if (meant != nullptr) remedy = fmt::format("did you mean \"{}\"?", meant->name);
  report(attribute.GetLineNum(), of.path, fmt::format("attribute \"{}\" is unknown", shown(attribute.Name())),
         std::move(remedy));
  if (meant == nullptr) return false;
  readOne(attribute, *meant, of);
  // What only the value suggests is no firm ground for further judgement.
  if (!like) of.text.attributes.back().known = false;
  return true;
}

/// What one attribute says for several (z for both ends) is said of each.
void PartReader::readStandingFor(Attributes& of) {
  for (const AttributeRow& several : of.row.attributes) {
    if (several.sets.empty() || !of.given.contains(several.name)) continue;
    const auto source = std::find_if(of.text.attributes.begin(), of.text.attributes.end(),
                                     [&](const AttributeText& each) { return each.name == several.name; });
    const AttributeText said = *source;
    for (const std::string& name : several.sets.strings()) {
      if (!of.given.insert(name).second) {
        report(of.element.GetLineNum(), of.path,
               fmt::format("\"{}\" and \"{}\" are both given, and {} stands for {}", several.name, name, several.name,
                           joined(several.sets.strings(), ", ")),
               "remove one of them");
        std::erase_if(of.text.attributes, [&](const AttributeText& each) { return each.name == name; });
      }
      of.text.attributes.push_back({name, said.written, said.text, said.line, true, said.known});
    }
  }
}

/// @param something_strange  an attribute of the element was not understood: it may mean any that is left out
void PartReader::addMissing(bool something_strange, Attributes& of) {
  const int line = of.element.GetLineNum();
  for (const AttributeRow& each : of.row.attributes) {
    if (of.given.contains(each.name)) continue;
    if (each.required) {
      report(line, of.path, fmt::format("attribute \"{}\" is missing", each.name),
             fmt::format("write e.g. {}", exampleOf(each, of.row)));
      if (each.kind == ValueKind::kFormat) continue;
      const Value instead = standInFor(each);
      if (!std::holds_alternative<std::monostate>(instead)) each.set(of.object, instead);
    }
    const bool known = !each.required && !something_strange;
    if (!known || !each.fallback.empty()) {
      of.text.attributes.push_back(
          {std::string(each.name), std::string(each.name), std::string(each.fallback), line, false, known});
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
    addStrange(child);
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
  addStrange(child);
  return nullptr;
}

/// Keeps the words of an element that means nothing: what they name may be in order all the same.
void PartReader::addStrange(const tinyxml2::XMLElement& element) {
  has_strange_ = true;
  for (const tinyxml2::XMLAttribute* each = element.FirstAttribute(); each != nullptr; each = each->Next()) {
    strange_words_.emplace_back(each->Value());
  }
  for (const tinyxml2::XMLElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    addStrange(*child);
  }
}

void PartReader::readChildren(const tinyxml2::XMLElement& element, const Scope& scope) {
  std::map<std::string, int> first_line;
  bool strange = false;  // of these children: one of them may be a required one that seems to be missing
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
    if (row == nullptr) {
      strange = true;
      continue;
    }
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
    if (!row.required || first_line.contains(row.name)) continue;
    if (!strange) {
      report(element.GetLineNum(), scope.path, fmt::format("element <{}> is missing", row.name),
             fmt::format("write e.g. {}", row.example));
    }
    Origin& origin = *row.origin(row.add(scope.object));
    origin = {{file_, element.GetLineNum()}};
    origin.text = std::make_shared<const PartText>(PartText{{}, false, false, {}, false});
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
  row.origin(object)->text = std::make_shared<const PartText>(readAttributes(child, row, object, path));
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
  static_cast<void>(readAttributes(element, row, nullptr, path));
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
