#include "libvehicle/report/run/run_document.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/report/document/shell_word.h"

namespace vehicle::report {
namespace {

RunResult resultAt(double speed, double peak) {
  RunResult result;
  result.speed = speed;
  result.statistics.steps = 7;
  result.history = TimeHistory(std::vector<Channel>{{"carbody.z", "m"}});
  ColumnSummary summary;
  summary.lowest = -peak;
  summary.highest = 0.5 * peak;
  result.summaries = {summary};
  return result;
}

const RunNames kNames = {"coach", "waves", "matrix", "exact"};

TEST(RunDocument, OfOneRunLeadsWithItsNamesAndItsSpeed) {
  const Document document = documentOf(kNames, resultAt(20.0, 3e-3), Format::kCsv);
  const std::vector<std::string> expected = {"vehicle", "scenario", "form", "method", "speed", "scheme"};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(document.facts.at(i).name, expected[i]);
  EXPECT_EQ(std::get<double>(document.facts[4].value), 20.0);
  ASSERT_EQ(document.tables.size(), 2u);
  EXPECT_TRUE(document.tables[0].rows.empty());  // nothing was left open
  EXPECT_EQ(std::get<double>(document.tables[1].rows.at(0).at(2)), -3e-3);
}

TEST(RunDocument, OfSeveralSpeedsHasALineARunAndEachColumnSpeedBySpeedInOneUnit) {
  const std::vector<RunResult> runs = {resultAt(20.0, 3e-3), resultAt(30.0, 2.0)};
  const Document document = documentOf(kNames, runs, Format::kTable);
  EXPECT_EQ(std::get<long>(document.facts.back().value), 2);
  ASSERT_EQ(document.tables.size(), 2u);
  EXPECT_EQ(document.tables[0].rows.size(), 2u);
  const Table& columns = document.tables[1];
  ASSERT_EQ(columns.rows.size(), 2u);
  for (const std::vector<Cell>& row : columns.rows) EXPECT_EQ(std::get<std::string>(row[1]), "m");  // 2 m decides
  EXPECT_EQ(std::get<double>(columns.rows[1][3]), -2.0);
}

TEST(ShellWord, IsInQuotesWhereAShellWouldTakeItApart) {
  EXPECT_EQ(shellWord("models/a-1.xml"), "models/a-1.xml");
  EXPECT_EQ(shellWord("my study.xml"), "'my study.xml'");
  EXPECT_EQ(shellWord("it's"), "'it'\\''s'");
  EXPECT_EQ(shellWord(""), "''");
}

TEST(Document, IsAppendedBehindAnother) {
  Document document{{{"first", 1L, ""}}, {}, {"a"}};
  append({{{"second", 2L, ""}}, {{"table", {}, {}}}, {"b"}}, document);
  ASSERT_EQ(document.facts.size(), 2u);
  EXPECT_EQ(document.facts[1].name, "second");
  EXPECT_EQ(document.tables.size(), 1u);
  EXPECT_EQ(document.remarks, (std::vector<std::string>{"a", "b"}));
}

}  // namespace
}  // namespace vehicle::report
