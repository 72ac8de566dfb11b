// Tables, facts and remarks on a page that is narrower than they are.
#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/report/document/document.h"

namespace vehicle::report {
namespace {

std::vector<std::string> printed(const Document& document, std::size_t width) {
  std::ostringstream out;
  print(document, Format::kTable, out, width);
  std::istringstream stream(out.str());
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> printed(Table table, std::size_t width) {
  Document document;
  document.tables = {std::move(table)};
  return printed(document, width);
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& each : lines) text += each + '\n';
  return text;
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

TEST(TextTable, HasLinesOfAnyLengthInAFile) {
  const std::vector<std::string> lines = printed(wide(40), kAnyWidth);
  ASSERT_EQ(lines.size(), 3u);  // name, header, row
  EXPECT_GT(lines[1].size(), 1000u);
}

TEST(TextTable, BreaksHeadersWhereItIsTooWide) {
  EXPECT_EQ(printed(wide(2), 120).size(), 3u);  // 94 letters: as they are
  EXPECT_EQ(joined(printed(wide(3), 120)),
            "wide\n"
            "        secondary_front.  secondary_front.  secondary_front.\n"
            "          deflection.rms    deflection.rms    deflection.rms\n"
            "  name     @ 0 km/h [mm]     @ 1 km/h [mm]     @ 2 km/h [mm]\n"
            "  base                 0                 1                 2\n");
}

TEST(TextTable, IsPartedBehindItsKeysWhereItIsStillTooWide) {
  const std::vector<std::string> lines = printed(wide(12), 120);
  // 6 letters for the name, 18 a column: 6 columns a part.
  ASSERT_EQ(lines.size(), 10u);
  for (const std::string& each : lines) EXPECT_LE(each.size(), 120u) << each;
  EXPECT_EQ(lines[4].substr(0, 6), "  base");
  EXPECT_EQ(lines[4].back(), '5');
  EXPECT_EQ(lines[5], "");
  EXPECT_EQ(lines[9].substr(0, 6), "  base");
  EXPECT_EQ(lines[9].substr(lines[9].size() - 2), "11");
}

TEST(TextTable, RepeatsAsManyKeysAsItHas) {
  Table table{"pairs", {{"run", ""}, {"against", ""}}, {}, 2};
  table.rows.push_back({std::string("a"), std::string("b")});
  for (const char* name : {"first", "second", "third"}) {
    table.columns.push_back({name, ""});
    table.rows[0].emplace_back(std::string(12, name[0]));
  }
  EXPECT_EQ(joined(printed(table, 32)),
            "pairs\n"
            "  run  against  first\n"
            "  a    b        ffffffffffff\n"
            "\n"
            "  run  against  second\n"
            "  a    b        ssssssssssss\n"
            "\n"
            "  run  against  third\n"
            "  a    b        tttttttttttt\n");
}

TEST(TextTable, WrapsTextsBetweenWordsAndCutsNone) {
  Table table{"not run", {{"form", ""}, {"why", ""}}, {}};
  table.rows.push_back({std::string("mbs"), std::string("no linear form, and the method exact needs one")});
  table.rows.push_back({std::string("flat"), std::string("a_word_that_is_longer_than_the_page_is_wide")});
  EXPECT_EQ(joined(printed(table, 34)),
            "not run\n"
            "  form  why\n"
            "  mbs   no linear form, and the\n"
            "        method exact needs one\n"
            "  flat  a_word_that_is_longer_than_the_page_is_wide\n");
}

TEST(TextTable, BreaksKeysThatTakeMostOfThePage) {
  Table table{"comparison", {{"quantity", ""}, {"unit", ""}, {"base", ""}, {"soft", ""}}, {}, 2};
  table.rows.push_back({std::string("secondary_front.deflection.peak @ 160 km/h"), std::string("mm"), 1.0, 2.0});
  EXPECT_EQ(joined(printed(table, 44)),
            "comparison\n"
            "  quantity          unit  base  soft\n"
            "  secondary_front.  mm       1     2\n"
            "  deflection.peak\n"
            "  @ 160 km/h\n");
}

TEST(TextTable, OfOneColumnIsWrappedToo) {
  Table table{"why", {{"why", ""}}, {}};
  table.rows.push_back({std::string("one two three four five six seven eight")});
  EXPECT_EQ(joined(printed(table, 30)), "why\n  why\n  one two three four five six\n  seven eight\n");
}

TEST(TextPage, WrapsFactsBelowTheirValuesAndRemarksFromTheLeft) {
  Document document;
  document.facts = {{"speed", 20.0, "m/s"}, {"chosen because", std::string("it was the fastest of four ways"), ""}};
  document.remarks = {"214 pairs inside their expected size, 0 outside"};
  EXPECT_EQ(joined(printed(document, 34)),
            "speed           72 km/h\n"
            "chosen because  it was the fastest\n"
            "                of four ways\n"
            "\n"
            "214 pairs inside their expected\n"
            "size, 0 outside\n");
}

TEST(TextPage, CountsLettersAndNotBytes) {
  Document document;
  document.remarks = {
      "\xc3\xa4\xc3\xb6\xc3\xbc \xc3\xa4\xc3\xb6\xc3\xbc"};  // two words of three letters, two bytes each
  EXPECT_EQ(printed(document, 7).size(), 1u);
  EXPECT_EQ(printed(document, 6).size(), 2u);
}

TEST(TextPage, ShowsAColumnInOneUnitAndAPlaceAsItIsGiven) {
  Table table{"bodies", {{"body", ""}, {"rest z", "m"}, {"x", "m", ColumnUnit::kAsGiven}}, {}};
  table.rows.push_back({std::string("carbody"), -0.1825, 0.5});
  table.rows.push_back({std::string("bogie"), 0.001, {}});
  EXPECT_EQ(joined(printed(table, kAnyWidth)),
            "bodies\n"
            "  body     rest z [mm]  x [m]\n"
            "  carbody       -182.5    0.5\n"
            "  bogie              1      -\n");
}

}  // namespace
}  // namespace vehicle::report
