#include "libvehicle/xml/writer.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/xml/attribute_value.h"
#include "libvehicle/xml/escape.h"
#include "libvehicle/xml/part_order.h"
#include "libvehicle/xml/schema.h"

namespace vehicle {

namespace {

using Written = std::vector<std::pair<std::string, std::string>>;  // attribute, text

/// Equal to the last bit: -0.0 is not 0.0.
bool isSame(const Value& a, const Value& b) {
  if (std::holds_alternative<double>(a) && std::holds_alternative<double>(b)) {
    return std::bit_cast<std::uint64_t>(std::get<double>(a)) == std::bit_cast<std::uint64_t>(std::get<double>(b));
  }
  return a == b;
}

Written attributesOf(const ElementRow& row, const void* object) {
  std::vector<std::string_view> covered;
  for (const AttributeRow& attribute : row.attributes) {
    const bool stands = !attribute.sets.empty() && !std::holds_alternative<std::monostate>(attribute.get(object));
    if (stands) covered.insert(covered.end(), attribute.sets.begin(), attribute.sets.end());
  }
  Written written;
  for (const AttributeRow& attribute : row.attributes) {
    if (attribute.reserved || std::find(covered.begin(), covered.end(), attribute.name) != covered.end()) continue;
    if (attribute.kind == ValueKind::kFormat) {
      written.emplace_back(attribute.name, kFileFormat);
      continue;
    }
    const Value value = attribute.get(object);
    const bool given = !std::holds_alternative<std::monostate>(value);
    const bool is_needed = attribute.required || !attribute.sets.empty() || !isSame(value, attribute.get(row.fresh()));
    if (given && is_needed) written.emplace_back(attribute.name, xmlEscaped(attributeText(attribute, value)));
  }
  if (row.reserved != nullptr) {
    // Accessors take a mutable struct; nothing is changed through it here.
    for (const ReservedQuantity& each : *row.reserved(const_cast<void*>(object))) {
      written.emplace_back(each.attribute, xmlEscaped(each.text));
    }
  }
  return written;
}

/// Writes elements line by line.
class Writer {
 public:
  std::string writeRoot(const ElementRow& row, const void* object) {
    text_ += fmt::format("<{}{}>\n", row.name, inLine(attributesOf(row, object)));
    bool titled = false;
    for (const ElementRow& child : row.children) {
      if (child.text == nullptr) continue;
      const std::string& text = *child.text(const_cast<void*>(object));
      if (text.empty()) continue;
      text_ += fmt::format("  <{0}>{1}</{0}>\n", child.name, xmlEscaped(text));
      titled = true;
    }
    writeParts(orderOfWriting(row, object), 1, titled ? Gap::kBefore : Gap::kNone);
    text_ += fmt::format("</{}>\n", row.name);
    return std::move(text_);
  }

 private:
  /// An empty line before parts of another kind.
  enum class Gap {
    kNone,
    kBefore,
  };

  static std::string inLine(const Written& written) {
    std::string line;
    for (const auto& [name, text] : written) line += fmt::format(" {}=\"{}\"", name, text);
    return line;
  }

  static bool isLeaf(const PartToWrite& part) { return part.row->children.empty() && !part.row->is_group; }

  /// Elements that can share columns: the same one, beginning with the same attribute.
  static bool isAlike(const PartToWrite& a, const PartToWrite& b) {
    if (a.row != b.row) return false;
    const Written first = attributesOf(*a.row, a.object);
    const Written second = attributesOf(*b.row, b.object);
    return first.empty() || second.empty() || first.front().first == second.front().first;
  }

  void writeParts(const std::vector<PartToWrite>& parts, int depth, Gap gap) {
    for (std::size_t begin = 0; begin < parts.size();) {
      std::size_t end = begin + 1;
      while (isLeaf(parts[begin]) && end < parts.size() && isAlike(parts[end], parts[begin])) ++end;
      if (depth == 1 && gap == Gap::kBefore && (end > begin + 1 || parts[begin].row->many)) text_ += '\n';
      const bool goes_on = end < parts.size() && parts[end].row == parts[begin].row;
      gap = goes_on && !parts[begin].row->is_group ? Gap::kNone : Gap::kBefore;
      if (isLeaf(parts[begin])) {
        const auto first = parts.begin();
        writeAligned({first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(end)}, depth);
      } else {
        writeParent(parts[begin], depth);
      }
      begin = end;
    }
  }

  void writeParent(const PartToWrite& part, int depth) {
    const std::vector<PartToWrite> children =
        part.row->is_group ? part.members : orderOfWriting(*part.row, part.object);
    const std::string indent(2 * static_cast<std::size_t>(depth), ' ');
    const std::string opening = indent + "<" + part.row->name + inLine(attributesOf(*part.row, part.object));
    if (children.empty()) {
      text_ += opening + "/>\n";
      return;
    }
    text_ += opening + ">\n";
    writeParts(children, depth + 1, Gap::kNone);
    text_ += fmt::format("{}</{}>\n", indent, part.row->name);
  }

  /// Equal elements, their attributes in columns.
  void writeAligned(const std::vector<PartToWrite>& parts, int depth) {
    std::vector<Written> lines;
    std::map<std::string, std::size_t, std::less<>> widths;
    std::vector<std::string_view> columns;  // in the order of the table, reserved ones as they come
    for (const AttributeRow& attribute : parts.front().row->attributes) columns.push_back(attribute.name);
    for (const PartToWrite& part : parts) {
      lines.push_back(attributesOf(*part.row, part.object));
      for (const auto& [name, text] : lines.back()) widths[name] = std::max(widths[name], text.size());
    }
    for (const Written& line : lines) {
      std::string out = std::string(2 * static_cast<std::size_t>(depth), ' ') + "<" + parts.front().row->name;
      // Reserved attributes keep their order among each other, which need not be the table's: they get no columns.
      std::size_t next = 0;
      for (const std::string_view column : columns) {
        if (widths.count(column) == 0 || isReserved(*parts.front().row, column)) continue;
        const bool given = next < line.size() && line[next].first == column;
        std::string cell = given ? fmt::format(" {}=\"{}\"", column, line[next].second) : "";
        cell.resize(widths.find(column)->second + column.size() + 4, ' ');
        out += cell;
        if (given) ++next;
      }
      if (next < line.size()) {
        out += inLine({line.begin() + static_cast<std::ptrdiff_t>(next), line.end()});
      }
      out.erase(out.find_last_not_of(' ') + 1);
      text_ += out + "/>\n";
    }
  }

  static bool isReserved(const ElementRow& row, std::string_view name) { return row.attribute(name)->reserved; }

  std::string text_;
};

}  // namespace

std::string write(const Vehicle& vehicle) { return Writer().writeRoot(schemaOf(FileKind::kVehicle), &vehicle); }
std::string write(const Train& train) { return Writer().writeRoot(schemaOf(FileKind::kTrain), &train); }
std::string write(const Scenario& scenario) { return Writer().writeRoot(schemaOf(FileKind::kScenario), &scenario); }
std::string write(const Suite& suite) { return Writer().writeRoot(schemaOf(FileKind::kSuite), &suite); }
std::string write(const Study& study) { return Writer().writeRoot(schemaOf(FileKind::kStudy), &study); }

}  // namespace vehicle
