#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/definition/attribute.h"
#include "libvehicle/definition/origin.h"

namespace vehicle {

// What may stand in a file: elements with their names, order, children and examples. What may be said of each is the
// table of attributes (definition/attribute.h), whose rows also know the struct members that they fill. Reader, writer,
// XSD and docs page are walks over both.

/// What a file is about, as its root element says.
enum class FileKind {
  kVehicle,
  kTrain,
  kScenario,
  kSuite,
  kStudy
};

/// The format of files that this program reads and writes: <vehicle format="1">.
inline constexpr std::string_view kFileFormat = "1";

struct ElementRow {
  std::string name;
  std::string sentence;
  std::string example;  // one line a user may copy
  bool required = false;
  bool many = false;      // may stand more than once
  bool in_group = false;  // may stand inside a <group> too
  bool is_group = false;  // holds its parent's in_group elements
  std::vector<AttributeRow> attributes;  // those of the struct; of a root also its format
  std::vector<ElementRow> children;

  // Text elements (<title>) fill a string of the parent; all others are objects of their own.
  std::string* (*text)(void* parent) = nullptr;
  std::size_t (*count)(const void* parent) = nullptr;
  const void* (*at)(const void* parent, std::size_t index) = nullptr;
  void* (*add)(void* parent) = nullptr;
  const void* (*fresh)() = nullptr;  // an object that nothing has been said about: the defaults
  Origin* (*origin)(void* object) = nullptr;
  std::string* (*group)(void* object) = nullptr;                       // null: belongs to no group
  std::vector<ReservedQuantity>* (*reserved)(void* object) = nullptr;  // null: reserves nothing

  [[nodiscard]] const AttributeRow* attribute(std::string_view attribute_name) const;
  [[nodiscard]] const ElementRow* child(std::string_view element_name) const;
};

/// The table of a kind of file; lives as long as the program.
[[nodiscard]] const ElementRow& schemaOf(FileKind kind);

/// All kinds, in the order of the docs.
[[nodiscard]] const std::vector<FileKind>& allFileKinds();

/// The range in words, e.g. "> 0", "1 to 2"; empty where every value will do.
[[nodiscard]] std::string rangeOf(const AttributeRow& row);

/// What a file could say there, e.g. `mass="57 t"`: as in the element's example if it stands there.
[[nodiscard]] std::string exampleOf(const AttributeRow& row, const ElementRow& element);

/// XML schema (XSD 1.0) of all kinds of file, for editors and xmllint. It knows elements, attributes, choices,
/// signs and the form of a quantity; dimensions and references only the reader judges.
[[nodiscard]] std::string xsd();

/// The page of the docs on XML files (Markdown).
[[nodiscard]] std::string schemaMarkdown();

}  // namespace vehicle
