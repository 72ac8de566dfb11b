#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "libvehicle/definition/origin.h"
#include "libvehicle/units/quantity.h"

namespace vehicle {

// The one table of what may stand in a file: every element with its attributes, dimensions, ranges, defaults
// and a sentence for the reader of the docs. Each row also knows the struct member that it fills, so reader,
// writer, XSD and docs page are walks over this table: a new attribute is one line in a *_schema.cc.

/// What a file is about, told by its root element.
enum class FileKind {
  kVehicle,
  kTrain,
  kScenario,
  kSuite,
  kStudy
};

/// The format of files that this program reads and writes: <vehicle format="1">.
inline constexpr std::string_view kFileFormat = "1";

enum class ValueKind {
  kFormat,      // kFileFormat; bound to no member
  kName,        // letters, digits, "_" and "-", beginning with a letter or digit; unique in the file
  kReference,   // the name of another part; of a train's part "coach_2.carbody"
  kFile,        // a path, counted from the folder of the naming file
  kText,        // words that definition's check() and bindStudy() read
  kQuantity,    // number with unit
  kInteger,     // whole number without unit
  kChoice,      // one word of a list
  kChoiceList,  // some words of a list, each once, with spaces between
};

/// Range of a quantity.
enum class Sign {
  kAny,
  kNotNegative,
  kPositive
};

/// A value between file and struct: quantity in SI, integer or index of a choice, text, indices of choices;
/// monostate: not given.
using Value = std::variant<std::monostate, double, int, std::string, std::vector<int>>;

struct AttributeRow {
  std::string name;
  ValueKind kind = ValueKind::kName;
  std::string sentence;
  bool required = false;
  bool reserved = false;                     // checked, kept as text in `reserved`, used by no planar form
  Dimension dimension = Dimension::kNumber;  // of a kQuantity
  Sign sign = Sign::kAny;                    // of a kQuantity
  int least = 0;                             // of a kInteger
  int most = 0;                              // of a kInteger
  std::vector<std::string> choices;          // of kChoice and kChoiceList; the index is the enumerator's value
  std::vector<std::string> spellings;        // of kChoice: each choice as others spell it; read and never written
  std::string fallback;                      // value where the attribute is not given, as a file would say it
  std::vector<std::string> sets;             // attributes that this one stands for (`z` for both ends)

  Value (*get)(const void* object) = nullptr;
  void (*set)(void* object, const Value& value) = nullptr;

  /// The same row with one thing changed, so that a table line reads as a sentence.
  [[nodiscard]] AttributeRow asRequired() const;
  [[nodiscard]] AttributeRow orElse(std::string text) const;
  [[nodiscard]] AttributeRow alsoWritten(std::vector<std::string> words) const;
  [[nodiscard]] AttributeRow standingFor(std::vector<std::string> names) const;
};

struct ElementRow {
  std::string name;
  std::string sentence;
  std::string example;  // one line a user may copy
  bool required = false;
  bool many = false;      // may stand more than once
  bool in_group = false;  // may stand inside a <group> too
  bool is_group = false;  // holds its parent's in_group elements
  std::vector<AttributeRow> attributes;
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
