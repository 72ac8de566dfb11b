#include "apps/cli/document.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace vehicle::cli {
namespace {

Document sample() {
  Table table{"bodies", {{"body", ""}, {"mass", "t"}, {"steps", ""}, {"fits", ""}}, {}};
  table.rows.push_back({std::string("carbody"), 57.0, 12L, true});
  table.rows.push_back({std::string("a \"b\", c"), 0.1 + 0.2, {}, false});
  return {{{"speed", 20.0, "m/s"}, {"vehicle", std::string("coach"), ""}},
          {table, {"empty", {{"x", ""}}, {}}},
          {"all well"}};
}

std::string printed(const Document& document, Format format) {
  std::ostringstream out;
  print(document, format, out);
  return out.str();
}

TEST(Document, TableIsAlignedWithUnitsAndFiveDigits) {
  EXPECT_EQ(printed(sample(), Format::kTable),
            "speed    20 m/s\n"
            "vehicle  coach\n"
            "\n"
            "bodies\n"
            "  body      mass [t]  steps  fits\n"
            "  carbody         57     12  yes\n"
            "  a \"b\", c       0.3      -  no\n"
            "\n"
            "all well\n");
}

/// Columns whose headers are wider than their numbers.
Table wide(std::size_t columns) {
  Table table{"wide", {{"name", ""}}, {}};
  std::vector<Cell>& row = table.rows.emplace_back();
  row.emplace_back(std::string("base"));
  for (std::size_t j = 0; j < columns; ++j) {
    table.columns.push_back({"secondary_front.deflection.rms @ " + std::to_string(j) + " km/h", "mm"});
    row.emplace_back(static_cast<long>(j));
  }
  return table;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(Document, HeadersOfATableThatIsTooWideAreBroken) {
  Document document;
  document.tables = {wide(2)};
  EXPECT_EQ(linesOf(printed(document, Format::kTable)).size(), 3u);  // 94 letters wide: as they are
  document.tables = {wide(3)};
  EXPECT_EQ(printed(document, Format::kTable),
            "wide\n"
            "        secondary_front.  secondary_front.  secondary_front.\n"
            "          deflection.rms    deflection.rms    deflection.rms\n"
            "  name     @ 0 km/h [mm]     @ 1 km/h [mm]     @ 2 km/h [mm]\n"
            "  base                 0                 1                 2\n");
}

TEST(Document, ATableWithKeyColumnsIsPartedWhereItIsStillTooWide) {
  Document document;
  document.tables = {wide(12)};
  EXPECT_EQ(linesOf(printed(document, Format::kTable)).size(), 5u);  // name, three lines of header, one row
  document.tables[0].key_columns = 1;
  const std::vector<std::string> lines = linesOf(printed(document, Format::kTable));
  // 6 letters for the name, 18 a column: 6 columns a part.
  ASSERT_EQ(lines.size(), 10u);
  for (const std::string& each : lines) EXPECT_LE(each.size(), 120u) << each;
  EXPECT_EQ(lines[4].substr(0, 6), "  base");
  EXPECT_EQ(lines[4].back(), '5');
  EXPECT_EQ(lines[5], "");
  EXPECT_EQ(lines[9].substr(0, 6), "  base");
  EXPECT_EQ(lines[9].substr(lines[9].size() - 2), "11");
}

TEST(Document, CsvHoldsTheTablesAndEveryBit) {
  EXPECT_EQ(printed(sample(), Format::kCsv),
            "body,mass [t],steps,fits\ncarbody,57,12,true\n\"a \"\"b\"\", c\",0.30000000000000004,,false\n");
}

TEST(Document, JsonHoldsAllAndNullWhereThereIsNoNumber) {
  Document document = sample();
  document.tables[0].rows[0][1] = std::numeric_limits<double>::infinity();
  const nlohmann::json read = nlohmann::json::parse(printed(document, Format::kJson));
  EXPECT_EQ(read["facts"]["speed"]["value"], 20.0);
  EXPECT_EQ(read["facts"]["speed"]["unit"], "m/s");
  EXPECT_EQ(read["tables"]["bodies"]["units"]["mass"], "t");
  EXPECT_TRUE(read["tables"]["bodies"]["rows"][0]["mass"].is_null());
  EXPECT_EQ(read["tables"]["bodies"]["rows"][1]["mass"].get<double>(), 0.1 + 0.2);
  EXPECT_TRUE(read["tables"]["empty"]["rows"].empty());
  EXPECT_EQ(read["remarks"][0], "all well");
}

TEST(Document, BytesThatAreNoUtf8DoNotBreakTheJson) {
  Document document;
  document.facts = {{"file", std::string("\xff.xml"), ""}};
  EXPECT_TRUE(nlohmann::json::accept(printed(document, Format::kJson)));
}

TEST(Document, MinusZeroIsZeroForTheEye) {
  Document document;
  document.facts = {{"difference", -0.0, "m"}};
  EXPECT_EQ(printed(document, Format::kTable), "difference  0 m\n");
}

}  // namespace
}  // namespace vehicle::cli
