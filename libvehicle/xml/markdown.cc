#include <string>

#include <fmt/format.h>

#include "libvehicle/xml/message_text.h"
#include "libvehicle/xml/schema.h"
#include "libvehicle/xml/text_guard.h"

namespace vehicle {

namespace {

constexpr std::string_view kHead = R"(# XML files

<!-- Written by the program from its schema table; a test compares the two. Change the table, not this page. -->

These kinds of file are read: `<vehicle>`, `<train>`, `<scenario>`, `<suite>` and `<study>`; `vehicle check FILE...`
judges any of them and prints all problems of a file in one pass, each as one line
`FILE:LINE: error: ELEMENT: what is wrong; what to do`. A value that could not be read is reported once: what depends on
it is not judged. `models/vehicle.xsd` is the same table for editors and
`xmllint --schema`; dimensions and references only the program judges. A train may stand wherever a vehicle is asked
for.

## Rules for every file

- A quantity carries its unit: `3040 kN/m`, `30 kN*s/m`, `57 t`, `70 t*m^2`, `70 tf*m*s^2`, `1.2 mrad`, `72 km/h`.
  A unit is a product or quotient of symbols with prefix and power. A missing, unknown or wrong unit is an error.
  Prefixes divide by powers of ten: 9 mm is the double nearest to 0.009 m. 1 tf = 9806.65 N.
- Names have up to 64 letters, digits, `_` and `-`, and begin with a letter or digit. They are unique in a file, so that
  `primary.stiffness_z`, `carbody.mass` or `front.x` address one number. Where a scenario means a part of a train it
  names the vehicle too: `coach_2.carbody`.
- Unknown elements and attributes are errors, never ignored. Elements may stand in any order; bodies, wheelsets and
  suspensions keep theirs in the results.
- Files named by a file count from its folder.
- Files are UTF-8 text of at most {} KiB. Document types, entities (but `&amp;`, `&lt;`, `&gt;`, `&quot;`, `&apos;` and
  character numbers) and processing instructions are refused; comments are free. What editors write to find the schema
  is accepted and ignored: `xmlns:xsi`, `xsi:noNamespaceSchemaLocation` and `xsi:schemaLocation` of the root element, and
  `<?xml-model ...?>` outside it.
- x is positive forward from an arbitrary origin, y to the left, z up from rail top at loaded rest; pitch is positive
  nose-up, roll and yaw are right-handed about x and z.
- Attributes marked *reserved* are for three-dimensional forms: their unit is checked, they are kept and written back
  unchanged, and no planar form uses them.
)";

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '<' || c == '*') out += '\\';
    out += c;
  }
  return out;
}

std::string valueOf(const AttributeRow& row) {
  switch (row.kind) {
    case ValueKind::kFormat:
      return fmt::format("`{}`", kFileFormat);
    case ValueKind::kName:
      return "a name";
    case ValueKind::kReference:
      return "name of a part";
    case ValueKind::kFile:
      return "a path";
    case ValueKind::kText:
      return "text";
    case ValueKind::kQuantity: {
      const DimensionInfo& info = describe(row.dimension);
      return row.dimension == Dimension::kNumber ? std::string(info.name)
                                                 : fmt::format("{}, e.g. `{}`", info.name, info.example);
    }
    case ValueKind::kInteger:
      return "whole number";
    case ValueKind::kChoice:
      return fmt::format(
          "`{}`{}", joined(row.choices.strings(), "`, `"),
          row.spellings.empty() ? "" : fmt::format(" (or `{}`)", joined(row.spellings.strings(), "`, `")));
    case ValueKind::kChoiceList:
      break;
  }
  return fmt::format("some of `{}`", joined(row.choices.strings(), "`, `"));
}

std::string fallbackOf(const AttributeRow& row) {
  if (row.required) return "required";
  if (row.reserved) return "*reserved*";
  return row.fallback.empty() ? "-" : fmt::format("`{}`", row.fallback);
}

std::string attributeTable(const ElementRow& row) {
  std::string out = "| attribute | value | range | without it | meaning |\n|---|---|---|---|---|\n";
  for (const AttributeRow& each : row.attributes) {
    std::string sentence(each.sentence);
    if (!each.sets.empty()) sentence += "; stands for " + joined(each.sets.strings(), ", ");
    out += fmt::format("| `{}` | {} | {} | {} | {} |\n", each.name, valueOf(each), rangeOf(each), fallbackOf(each),
                       escaped(sentence));
  }
  return out;
}

std::string occurrence(const ElementRow& row) {
  if (row.many) return "any number";
  return row.required ? "once" : "at most once";
}

void describeElement(const ElementRow& row, const std::string& path, std::string& out) {
  for (const ElementRow& child : row.children) {
    const std::string child_path = fmt::format("{}<{}>", path, child.name);
    out += fmt::format("\n### `{}`\n\n{} ({}{})\n\n```xml\n{}\n```\n", child_path, escaped(child.sentence),
                       occurrence(child), child.in_group ? ", inside a `<group>` too" : "", child.example);
    if (!child.attributes.empty()) out += fmt::format("\n{}", attributeTable(child));
    describeElement(child, child_path, out);
  }
}

}  // namespace

std::string schemaMarkdown() {
  std::string out = fmt::format(fmt::runtime(kHead), kMostBytes / 1024);
  for (const FileKind kind : allFileKinds()) {
    const ElementRow& root = schemaOf(kind);
    out += fmt::format("\n## `<{}>`\n\n{}\n\n```xml\n{}\n```\n\n{}", root.name, escaped(root.sentence), root.example,
                       attributeTable(root));
    describeElement(root, fmt::format("<{}>", root.name), out);
  }
  return out;
}

}  // namespace vehicle
