#include "libvehicle/storage/csv.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "tests/storage/histories.h"
#include "tests/support/test_folder.h"

namespace vehicle {
namespace {

using test::awkwardHistory;
using test::TestFolder;
using test::textOf;

std::string problemsOf(const std::string& text) {
  const TestFolder scratch;
  scratch.file("run.csv", text);
  std::string lines = readCsv(scratch.path("run.csv")).problems.text();
  const std::string folder = scratch.path("");
  for (std::size_t at = lines.find(folder); at != std::string::npos; at = lines.find(folder)) {
    lines.erase(at, folder.size());
  }
  return lines;
}

TEST(Csv, HeaderNamesColumnsAndUnitsAndNumbersAreTheShortestText) {
  const TestFolder scratch;
  TimeHistory history({{"carbody.z", "m"}, {"primary_1.force", "N"}});
  history.append(0.0)[1] = 0.1;
  const auto row = history.append(0.005);
  row[1] = -1.0 / 3.0;
  row[2] = 1e22;
  writeCsv(history, scratch.path("run.csv"));
  EXPECT_EQ(textOf(scratch.path("run.csv")),
            "time [s],carbody.z [m],primary_1.force [N]\n"
            "0,0.1,0\n"
            "0.005,-0.3333333333333333,1e+22\n");
}

TEST(Csv, EveryNumberReadsBackToTheSameBits) {
  const TestFolder scratch;
  const TimeHistory history = awkwardHistory();
  writeCsv(history, scratch.path("run.csv"));
  const TimeHistory back = readCsv(scratch.path("run.csv")).orThrow();
  EXPECT_EQ(back.columns(), history.columns());
  ASSERT_EQ(back.samples(), history.samples());
  // Of zero alone the sign is lost: x + 0 is x, and 0 of -0.
  for (std::size_t i = 0; i < history.samples(); ++i) {
    for (std::size_t j = 0; j < history.columns().size(); ++j) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(back.at(i, j)), std::bit_cast<std::uint64_t>(history.at(i, j) + 0.0))
          << "sample " << i << ", column " << j << ": " << back.at(i, j) << " for " << history.at(i, j);
    }
  }
}

TEST(Csv, HistoryWithoutSamplesKeepsItsColumns) {
  const TestFolder scratch;
  const TimeHistory history(std::vector<Channel>{{"carbody.z", "m"}});
  writeCsv(history, scratch.path("run.csv"));
  const TimeHistory back = readCsv(scratch.path("run.csv")).orThrow();
  EXPECT_EQ(back.columns(), history.columns());
  EXPECT_EQ(back.samples(), 0u);
}

TEST(Csv, FilesEditedElsewhereAreRead) {  // byte-order mark, CR LF, no end of the last line
  const TestFolder scratch;
  scratch.file("run.csv", "\xEF\xBB\xBFtime [s],carbody.z [m]\r\n0,1e-3\r\n0.005,-2.5");
  const TimeHistory history = readCsv(scratch.path("run.csv")).orThrow();
  ASSERT_EQ(history.samples(), 2u);
  EXPECT_EQ(history.at(0, 1), 1e-3);
  EXPECT_EQ(history.at(1, 1), -2.5);
  scratch.file("old.csv", "time [s],carbody.z [m]\r0,1e-3\r0.005,-2.5\r");  // CR alone
  EXPECT_EQ(readCsv(scratch.path("old.csv")).orThrow().at(1, 1), -2.5);
}

TEST(Csv, ValueThatIsNotFiniteIsNeverWritten) {
  const TestFolder scratch;
  TimeHistory history(std::vector<Channel>{{"carbody.z", "m"}});
  history.append(0.0);
  history.append(0.25)[1] = std::numeric_limits<double>::quiet_NaN();
  try {
    writeCsv(history, scratch.path("run.csv"));
    FAIL() << "wrote nan";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "history: column \"carbody.z\" is nan at time 0.25 s, must be finite");
  }
  EXPECT_EQ(scratch.entries(), 0u);
  EXPECT_THROW(writeCsv(TimeHistory(), scratch.path("run.csv")), std::invalid_argument);
}

TEST(CsvReader, WrongHeadersAreNamed) {
  const std::string remedy = "; a header reads e.g. \"time [s],carbody.z [m]\"\n";
  EXPECT_EQ(problemsOf("t,zk\n0,0\n"), "run.csv:1: error: column \"t\" has no name with a unit in brackets" + remedy +
                                           "run.csv:1: error: column \"zk\" has no name with a unit in brackets" +
                                           remedy);
  EXPECT_EQ(problemsOf("carbody.z [m]\n0\n"),
            "run.csv:1: error: the first column is \"carbody.z [m]\", must be \"time [s]\"" + remedy);
  EXPECT_EQ(problemsOf(""), "run.csv:1: error: column \"\" has no name with a unit in brackets" + remedy);
  EXPECT_EQ(problemsOf("time [s],a [m],a [m]\n"), "run.csv:1: error: column \"a\" stands there twice\n");
  EXPECT_EQ(problemsOf("time [s],\"a [m]\n"), "run.csv:1: error: a quote in the header is never closed\n");
}

TEST(CsvReader, EveryWrongRowIsNamedWithItsLine) {
  EXPECT_EQ(problemsOf("time [s],a [m],b [m]\n0,1,2\n1,2\n2,3,4,5\n3,,5\n4,1.5x,6\n5,nan,7\n6,1e999,7\n\n"),
            "run.csv:3: error: the row has 2 fields, the header 3\n"
            "run.csv:4: error: the row has 4 fields, the header 3\n"
            "run.csv:5: error: column \"a\": \"\" is no finite number\n"
            "run.csv:6: error: column \"a\": \"1.5x\" is no finite number\n"
            "run.csv:7: error: column \"a\": \"nan\" is no finite number\n"
            "run.csv:8: error: column \"a\": \"1e999\" is no finite number\n"
            "run.csv:9: error: column \"time\": \"\" is no finite number\n");
}

TEST(CsvReader, AFileOfWrongRowsEndsAfterTwentyProblems) {
  std::string text = "time [s]\n";
  for (int i = 0; i < 10000; ++i) text += "x\n";
  const TestFolder scratch;
  scratch.file("run.csv", text);
  EXPECT_EQ(readCsv(scratch.path("run.csv")).problems.size(), 20u);
}

TEST(CsvReader, AFileWithoutEndIsRefusedBeforeItFillsTheMemory) {
  EXPECT_EQ(readCsv("/dev/zero").problems.text(), "/dev/zero: error: cannot be read: File too large\n");
}

TEST(CsvReader, MissingFileAndFolderAreToldWithTheSystemsReason) {
  const TestFolder scratch;
  const std::string missing = scratch.path("missing.csv");
  EXPECT_EQ(readCsv(missing).problems.text(), missing + ": error: cannot be read: No such file or directory\n");
  const std::string folder = scratch.path("");
  EXPECT_EQ(readCsv(folder).problems.text(), folder + ": error: cannot be read: Is a directory\n");
}

}  // namespace
}  // namespace vehicle
