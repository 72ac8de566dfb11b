#include "libvehicle/xml/schema.h"

#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

#include "libvehicle/xml/attribute_value.h"
#include "tests/support/source_tree.h"

namespace vehicle {
namespace {

template <class Visit>
void visitAll(const ElementRow& row, const Visit& visit) {
  visit(row);
  for (const ElementRow& child : row.children) visitAll(child, visit);
}

template <class Visit>
void visitTable(const Visit& visit) {
  for (const FileKind kind : allFileKinds()) visitAll(schemaOf(kind), visit);
}

TEST(Schema, DefaultsAreThoseOfTheStructs) {
  int defaults = 0;
  visitTable([&defaults](const ElementRow& row) {
    for (const AttributeRow& each : row.attributes) {
      if (each.required || each.reserved) continue;
      SCOPED_TRACE(row.name + " " + std::string(each.name));
      const Value in_struct = each.get(row.fresh());
      if (each.fallback.empty()) {
        const bool nothing = std::holds_alternative<std::monostate>(in_struct) || in_struct == Value(std::string());
        EXPECT_TRUE(nothing || !each.sets.empty());
        continue;
      }
      const AttributeReading reading = readAttribute(each, each.fallback);
      EXPECT_EQ(reading.message, "");
      EXPECT_EQ(reading.value, in_struct);
      ++defaults;
    }
  });
  EXPECT_GT(defaults, 15);
}

// Binding a row to the wrong member would make one attribute overwrite another.
TEST(Schema, EveryAttributeFillsAMemberOfItsOwn) {
  visitTable([](const ElementRow& row) {
    if (row.text != nullptr) return;
    for (const AttributeRow& each : row.attributes) {
      if (each.reserved || each.kind == ValueKind::kFormat || !each.sets.empty()) continue;
      SCOPED_TRACE(row.name + " " + std::string(each.name));
      EXPECT_NE(each.get, nullptr);
      for (const AttributeRow& other : row.attributes) {
        if (&other == &each || other.get == nullptr || !other.sets.empty()) continue;
        EXPECT_NE(each.get, other.get) << other.name;
      }
    }
  });
}

TEST(Schema, EveryRowHasASentenceAndAnExampleThatTheReaderAccepts) {
  visitTable([](const ElementRow& row) {
    EXPECT_FALSE(row.sentence.empty()) << row.name;
    EXPECT_EQ(row.example.find("<" + row.name), 0u) << row.name;
    std::set<std::string> names;
    for (const AttributeRow& each : row.attributes) {
      SCOPED_TRACE(row.name + " " + std::string(each.name));
      EXPECT_FALSE(each.sentence.empty());
      EXPECT_TRUE(names.emplace(each.name).second);
      for (const std::string_view other : each.sets) EXPECT_NE(row.attribute(other), nullptr) << other;
      if (each.kind != ValueKind::kQuantity && !each.required) continue;
      const std::string example = exampleOf(each, row);
      const std::string value = example.substr(each.name.size() + 2, example.size() - each.name.size() - 3);
      EXPECT_EQ(readAttribute(each, value).message, "") << example;
    }
  });
}

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Both are written by the program: vehicle schema --xsd, vehicle schema --markdown.
TEST(Schema, TheCommittedFilesAreThoseOfTheTable) {
  EXPECT_EQ(contentOf(test::sourcePath("models/vehicle.xsd")), xsd());
  EXPECT_EQ(contentOf(test::sourcePath("docs/xml.md")), schemaMarkdown());
}

}  // namespace
}  // namespace vehicle
