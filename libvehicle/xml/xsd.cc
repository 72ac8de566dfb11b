#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/xml/message_text.h"
#include "libvehicle/xml/schema.h"

namespace vehicle {

namespace {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else {
      out += c;
    }
  }
  return out;
}

std::string documentation(std::string_view sentence) {
  return fmt::format("<xs:annotation><xs:documentation>{}</xs:documentation></xs:annotation>", escaped(sentence));
}

constexpr std::string_view kUnsigned = R"(([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+\-]?[0-9]+)?)";

/// Form of a quantity: a number and, but for plain numbers, something that may be a unit.
std::string patternOf(Dimension dimension, Sign sign) {
  // A value that may not be negative may still be written -0: only > 0 forbids the sign altogether.
  const std::string_view signs = sign == Sign::kPositive ? "\\+?" : "[+\\-]?";
  const std::string_view unit = dimension == Dimension::kNumber ? "" : R"(\s*[^\s0-9+\-.].*)";
  return fmt::format(R"(\s*{}{}{}\s*)", signs, kUnsigned, unit);
}

std::string typeNameOf(Dimension dimension, Sign sign) {
  std::string name(describe(dimension).name);
  for (char& c : name) c = c == ' ' ? '_' : c;
  return name + (sign == Sign::kPositive ? ".positive" : "");
}

/// Writes complex types from the inside out, one per element of the table, named by its path.
class XsdWriter {
 public:
  std::string run() {
    for (const FileKind kind : allFileKinds()) writeType(schemaOf(kind), schemaOf(kind).name, nullptr);
    std::string out =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<!-- Written by the program from its schema table; a test compares the two. Change the table, not this file. "
        "-->\n"
        "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\">\n";
    for (const FileKind kind : allFileKinds()) {
      out += fmt::format("  <xs:element name=\"{0}\" type=\"{0}\"/>\n", schemaOf(kind).name);
    }
    return fmt::format("{}\n{}{}</xs:schema>\n", out, simpleTypes(), complex_);
  }

 private:
  static std::string simpleType(std::string_view name, std::string_view facets) {
    return fmt::format(
        "  <xs:simpleType name=\"{}\"><xs:restriction base=\"xs:string\">{}</xs:restriction></xs:simpleType>\n", name,
        facets);
  }

  std::string simpleTypes() const {
    std::string out = simpleType("name", R"(<xs:pattern value="[A-Za-z0-9][A-Za-z0-9_\-]{0,63}"/>)");
    out += simpleType("reference",
                      R"(<xs:pattern value="([A-Za-z0-9][A-Za-z0-9_\-]{0,69}\.)?[A-Za-z0-9][A-Za-z0-9_\-]{0,63}"/>)");
    out += simpleType("file", R"(<xs:pattern value="\s*\S.*"/>)");
    out += simpleType("words", R"(<xs:pattern value="\s*\S.*"/>)");
    out += simpleType("format", fmt::format("<xs:enumeration value=\"{}\"/>", kFileFormat));
    for (const auto& [dimension, sign] : quantities_) {
      const DimensionInfo& info = describe(dimension);
      const std::string note =
          fmt::format("{}, e.g. {}{}", info.name, info.example, sign == Sign::kPositive ? "; must be > 0" : "");
      out += fmt::format(
          "  <xs:simpleType name=\"{}\">{}<xs:restriction base=\"xs:string\"><xs:pattern "
          "value=\"{}\"/></xs:restriction></xs:simpleType>\n",
          typeNameOf(dimension, sign), documentation(note), escaped(patternOf(dimension, sign)));
    }
    return out + "\n";
  }

  /// type="..." of an attribute, or the body of a type of its own.
  std::pair<std::string, std::string> typeOf(const AttributeRow& row) {
    switch (row.kind) {
      case ValueKind::kFormat:
        return {"format", ""};
      case ValueKind::kName:
        return {"name", ""};
      case ValueKind::kReference:
        return {"reference", ""};
      case ValueKind::kFile:
        return {"file", ""};
      case ValueKind::kText:
        return {"words", ""};
      case ValueKind::kQuantity: {
        const Sign sign = row.sign == Sign::kPositive ? Sign::kPositive : Sign::kAny;
        quantities_.emplace(row.dimension, sign);
        return {typeNameOf(row.dimension, sign), ""};
      }
      case ValueKind::kInteger:
        return {"", fmt::format("<xs:restriction base=\"xs:integer\"><xs:minInclusive value=\"{}\"/><xs:maxInclusive "
                                "value=\"{}\"/></xs:restriction>",
                                row.least, row.most)};
      case ValueKind::kChoice:
        return {"", choices(row)};
      case ValueKind::kChoiceList:
        break;
    }
    return {"", fmt::format("<xs:restriction><xs:simpleType><xs:list><xs:simpleType>{}</xs:simpleType></xs:list>"
                            "</xs:simpleType><xs:minLength value=\"1\"/></xs:restriction>",
                            choices(row))};
  }

  static std::string choices(const AttributeRow& row) {
    std::string out = "<xs:restriction base=\"xs:string\">";
    for (const Words* words : {&row.choices, &row.spellings}) {
      for (const std::string_view choice : *words) out += fmt::format("<xs:enumeration value=\"{}\"/>", choice);
    }
    return out + "</xs:restriction>";
  }

  std::string attribute(const AttributeRow& row) {
    const auto [type, body] = typeOf(row);
    // What another attribute may stand for cannot be demanded in XSD 1.0.
    std::string out = fmt::format("    <xs:attribute name=\"{}\"", row.name);
    if (!type.empty()) out += fmt::format(" type=\"{}\"", type);
    if (row.required && replaceable_.count(std::string(row.name)) == 0) out += " use=\"required\"";
    if (!row.fallback.empty()) out += fmt::format(" default=\"{}\"", row.fallback);
    const std::string note =
        documentation(std::string(row.sentence) + (row.reserved ? " (reserved for 3-D forms)" : ""));
    out += ">" + note;
    if (type.empty()) out += "<xs:simpleType>" + body + "</xs:simpleType>";
    return out + "</xs:attribute>\n";
  }

  static std::string typeNameOfElement(const ElementRow& row, const std::string& path) {
    return row.text != nullptr ? "xs:string" : path + "." + row.name;
  }

  void writeType(const ElementRow& row, const std::string& path, const ElementRow* parent) {
    const std::vector<ElementRow>& family = row.is_group ? parent->children : row.children;
    const std::string home = row.is_group ? path.substr(0, path.rfind('.')) : path;
    std::string out = fmt::format("  <xs:complexType name=\"{}\">{}\n", path, documentation(row.sentence));
    bool any_many = false;
    std::string members;
    for (const ElementRow& child : family) {
      if (row.is_group && !child.in_group) continue;
      any_many = any_many || child.many;
      members += fmt::format("      <xs:element name=\"{}\" type=\"{}\"{}/>\n", child.name,
                             typeNameOfElement(child, home), child.many || child.required ? "" : " minOccurs=\"0\"");
    }
    // XSD 1.0 can say "each at most once, in any order" or "any number, in any order", not a mixture.
    if (!members.empty()) {
      out += any_many ? "    <xs:choice minOccurs=\"0\" maxOccurs=\"unbounded\">\n" : "    <xs:all>\n";
      out += members + (any_many ? "    </xs:choice>\n" : "    </xs:all>\n");
    }
    replaceable_.clear();
    for (const AttributeRow& each : row.attributes) replaceable_.insert(each.sets.begin(), each.sets.end());
    for (const AttributeRow& each : row.attributes) out += attribute(each);
    complex_ += out + "  </xs:complexType>\n";
    for (const ElementRow& child : row.children) {
      if (child.text == nullptr) writeType(child, path + "." + child.name, &row);
    }
  }

  std::string complex_;
  std::set<std::pair<Dimension, Sign>> quantities_;
  std::set<std::string> replaceable_;  // attributes of the element at hand that another one may stand for
};

}  // namespace

std::string xsd() { return XsdWriter().run(); }

}  // namespace vehicle
