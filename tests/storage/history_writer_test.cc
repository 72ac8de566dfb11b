#include "libvehicle/storage/history_writer.h"

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/storage/csv.h"
#include "libvehicle/storage/hdf5.h"
#include "libvehicle/storage/history_file.h"
#include "tests/storage/histories.h"
#include "tests/support/refusal.h"
#include "tests/support/test_folder.h"

namespace vehicle {
namespace {

using test::TestFolder;
using test::textOf;

const RunDescription kDescription{{{"version", "0.1.0"}, {"form", "flat"}}, {{"v.xml", "<vehicle/>\n"}}};

RunRecord recordOf(const TimeHistory& history) { return {history, kDescription.attributes, kDescription.inputs}; }

TimeHistory longHistory(int samples) {
  TimeHistory history({{"carbody.z", "m"}, {"front_bogie.z", "m"}, {"strange, \"quoted\" name", "N/m^2"}});
  for (int i = 0; i < samples; ++i) {
    const auto row = history.append(0.005 * i);
    for (std::size_t j = 1; j < row.size(); ++j) row[j] = 1.0 / (3.0 * i + static_cast<double>(j)) - 1e-3;
  }
  return history;
}

/// Sample by sample, as a run does.
/// @param expected  samples that were announced
void stream(const TimeHistory& history, long expected, HistorySink& sink) {
  sink.begin(history.columns(), expected);
  for (std::size_t i = 0; i < history.samples(); ++i) sink.add(history.row(i));
}

// One sample, a chunk of HDF5 but for one, whole, and one more; several chunks, and megabytes of text.
TEST(HistoryWriter, StreamedFilesAreThoseOfTheStoredHistoryToTheLastByte) {
  for (const int samples : {1, 8191, 8192, 8193, 20000}) {
    const TestFolder scratch;
    const TimeHistory history = longHistory(samples);
    for (const std::string name : {"run.csv", "run.h5"}) {
      writeHistory(scratch.path("stored-" + name), recordOf(history));
      HistoryFiles files({scratch.path("streamed-" + name)});
      stream(history, samples, files);
      files.publish(kDescription);
      EXPECT_TRUE(textOf(scratch.path("stored-" + name)) == textOf(scratch.path("streamed-" + name)))
          << name << ", " << samples << " samples";
    }
  }
}

TEST(HistoryWriter, ARunThatEndsEarlyLeavesWhatItHas) {
  for (const int samples : {1, 100, 9000}) {
    const TestFolder scratch;
    const TimeHistory history = longHistory(samples);
    HistoryFiles files({scratch.path("run.csv"), scratch.path("run.h5")});
    stream(history, 20000, files);
    files.publish(kDescription);
    writeCsv(history, scratch.path("stored.csv"));
    EXPECT_TRUE(textOf(scratch.path("run.csv")) == textOf(scratch.path("stored.csv"))) << samples;
    const RunRecord back = readHdf5(scratch.path("run.h5")).orThrow();
    EXPECT_EQ(back.attributes, kDescription.attributes);
    EXPECT_EQ(back.inputs, kDescription.inputs);
    ASSERT_EQ(back.history.samples(), history.samples());
    for (std::size_t j = 0; j < history.columns().size(); ++j) EXPECT_EQ(back.history.column(j), history.column(j));
  }
}

TEST(HistoryWriter, ARunThatFailsLeavesNothingAndWhatStoodThere) {
  const TestFolder scratch;
  scratch.file("run.csv", "old");
  {
    HistoryFiles files({scratch.path("run.csv"), scratch.path("run.h5")});
    stream(longHistory(20000), 100000, files);
    EXPECT_EQ(textOf(scratch.path("run.csv")), "old");
  }
  EXPECT_EQ(textOf(scratch.path("run.csv")), "old");
  EXPECT_EQ(scratch.entries(), 1u);
}

TEST(HistoryWriter, FilesThatCannotBeWrittenAreRefusedAtTheBegin) {
  const TestFolder scratch;
  EXPECT_THROW(HistoryFiles({scratch.path("run.csv"), scratch.path("missing/run.h5")}), RunFailed);
  EXPECT_EQ(scratch.entries(), 0u);
  EXPECT_EQ(test::refusalOf([&] { HistoryFiles files({"run.mat"}); }),
            "run.mat: extension \".mat\" is unknown; name it .csv (text) or .h5 (HDF5)");
}

TEST(HistoryWriter, AValueThatIsNoNumberIsRefusedByColumnAndTime) {
  const TestFolder scratch;
  for (const std::string name : {"run.csv", "run.h5"}) {
    HistoryFiles files({scratch.path(name)});
    files.begin({{"time", "s"}, {"carbody.z", "m"}}, 2);
    const std::vector<double> row = {0.5, std::numeric_limits<double>::quiet_NaN()};
    EXPECT_EQ(test::refusalOf([&] { files.add(row); }),
              "history: column \"carbody.z\" is nan at time 0.5 s, must be finite");
  }
  EXPECT_EQ(scratch.entries(), 0u);
}

// A long train: more columns than a chunk of full length is kept of.
TEST(HistoryWriter, ThousandsOfColumnsAreWrittenToo) {
  const TestFolder scratch;
  std::vector<Channel> channels;
  for (int j = 0; j < 1200; ++j) channels.push_back({"column_" + std::to_string(j), "m"});
  TimeHistory history(channels);
  for (int i = 0; i < 20; ++i) {
    const auto row = history.append(i);
    for (std::size_t j = 1; j < row.size(); ++j) row[j] = static_cast<double>(j) + i;
  }
  writeHdf5(recordOf(history), scratch.path("run.h5"));
  const RunRecord back = readHdf5(scratch.path("run.h5")).orThrow();
  EXPECT_EQ(back.history.columns(), history.columns());
  EXPECT_EQ(back.history.column(1199), history.column(1199));
}

}  // namespace
}  // namespace vehicle
