#include "libvehicle/storage/hdf5.h"

#include <bit>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "libvehicle/storage/csv.h"
#include "libvehicle/storage/history_file.h"
#include "tests/storage/histories.h"
#include "tests/support/source_tree.h"
#include "tests/support/test_folder.h"

namespace vehicle {
namespace {

using test::awkwardHistory;
using test::TestFolder;
using test::textOf;

RunRecord exampleRecord() {
  return {.history = awkwardHistory(),
          .attributes = {{"version", "0.1.0"}, {"form", "flat"}, {"method", "exact"}, {"seed", ""}},
          .inputs = {{"models/vehicles/coach.xml", "<vehicle name=\"Z\xC3\xBCrich\"/>\n"}, {"empty.xml", ""}}};
}

std::string messageOf(const RunRecord& record) {
  const TestFolder scratch;
  try {
    writeHdf5(record, scratch.path("run.h5"));
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(scratch.entries(), 0u);
    return error.what();
  }
  return "written";
}

TEST(Hdf5, ARecordReadsBackToTheSameBits) {
  const TestFolder scratch;
  const RunRecord record = exampleRecord();
  writeHdf5(record, scratch.path("run.h5"));
  const RunRecord back = readHdf5(scratch.path("run.h5")).orThrow();
  EXPECT_EQ(back.attributes, record.attributes);
  EXPECT_EQ(back.inputs, record.inputs);
  EXPECT_EQ(back.history.columns(), record.history.columns());
  ASSERT_EQ(back.history.samples(), record.history.samples());
  // Of zero alone the sign is lost: x + 0 is x, and 0 of -0.
  for (std::size_t i = 0; i < back.history.samples(); ++i) {
    for (std::size_t j = 0; j < back.history.columns().size(); ++j) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(back.history.at(i, j)),
                std::bit_cast<std::uint64_t>(record.history.at(i, j) + 0.0))
          << "sample " << i << ", column " << j;
    }
  }
}

TEST(Hdf5, ColumnsKeepTheirOrderBeyondAnyAlphabet) {
  const TestFolder scratch;
  std::vector<Channel> channels;
  for (int i = 40; i > 0; --i) channels.push_back({"column_" + std::to_string(i), "m"});
  const RunRecord record{TimeHistory(channels), {}, {}};
  writeHdf5(record, scratch.path("run.h5"));
  EXPECT_EQ(readHdf5(scratch.path("run.h5")).orThrow().history.columns(), record.history.columns());
}

TEST(Hdf5, TheSameRecordGivesTheSameBytes) {
  const TestFolder scratch;
  writeHdf5(exampleRecord(), scratch.path("a.h5"));
  // HDF5 stores times in whole seconds: only a later second would show one.
  const std::time_t written = std::time(nullptr);
  while (std::time(nullptr) == written) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  writeHdf5(exampleRecord(), scratch.path("b.h5"));
  EXPECT_EQ(textOf(scratch.path("a.h5")), textOf(scratch.path("b.h5")));
}

TEST(Hdf5, WhatItCannotHoldIsRefusedByName) {
  const RunRecord slash{TimeHistory(std::vector<Channel>{{"front/bogie.z", "m"}}), {}, {}};
  EXPECT_EQ(messageOf(slash),
            "run record: column \"front/bogie.z\" is no name in HDF5; must not be empty, \".\" or hold \"/\"");
  RunRecord twice = exampleRecord();
  twice.attributes.emplace_back("form", "matrix");
  EXPECT_EQ(messageOf(twice), "run record: attribute \"form\" twice");
  RunRecord zero = exampleRecord();
  zero.inputs[0].text[3] = '\0';
  EXPECT_EQ(messageOf(zero), "run record: input file \"models/vehicles/coach.xml\" holds a zero byte, must be text");
  RunRecord infinite = exampleRecord();
  infinite.history.append(7.5)[1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(messageOf(infinite), "history: column \"carbody.z\" is inf at time 7.5 s, must be finite");
}

// A file that an earlier version wrote, whose texts have variable length.
TEST(Hdf5Reader, TextsOfVariableLengthAreReadToo) {
  const RunRecord record = readHdf5(test::sourcePath("tests/storage/data/texts-of-variable-length.h5")).orThrow();
  ASSERT_EQ(record.inputs.size(), 2u);
  EXPECT_EQ(record.inputs[0].name, "v.xml");
  EXPECT_EQ(record.inputs[0].text.substr(0, 34), "<vehicle name=\"small\" format=\"1\">\n");
  EXPECT_EQ(record.history.samples(), 5u);
  EXPECT_EQ(record.history.columns()[1], (Channel{"carbody.z", "m"}));
  bool has_form = false;
  for (const auto& [name, value] : record.attributes) has_form = has_form || (name == "form" && value == "matrix");
  EXPECT_TRUE(has_form);
}

// Octave gives up a whole file for one text that it cannot read, and prints pages about it.
TEST(Hdf5, OctaveReadsHistoryAndTextsWithoutAWord) {
  const TestFolder scratch;
  writeHdf5(exampleRecord(), scratch.path("run.h5"));
  const std::string script =
      "s = load('" + scratch.path("run.h5") + "'); h = s.history; f = fopen('" + scratch.path("seen") +
      "', 'w'); fprintf(f, '%s|%s|%d|%.17g', s.inputs._1, s.inputs._2, numel(h.time), h.time(2)); fclose(f);";
  const std::string command = std::string(VEHICLE_OCTAVE) + " --no-gui --norc --quiet --no-history --eval \"" + script +
                              "\" >'" + scratch.path("said") + "' 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << textOf(scratch.path("said"));
  EXPECT_EQ(textOf(scratch.path("said")), "");
  const RunRecord record = exampleRecord();
  EXPECT_EQ(textOf(scratch.path("seen")),
            fmt::format("{}||{}|{:.17g}", record.inputs[0].text, record.history.samples(), record.history.at(1, 0)));
}

TEST(Hdf5Reader, OtherFilesAreToldApartAndNothingIsPrinted) {
  const TestFolder scratch;
  const std::string path = scratch.path("run.h5");
  ::testing::internal::CaptureStderr();
  scratch.file("run.h5", "time [s]\n0\n");
  EXPECT_EQ(readHdf5(path).problems.text(), path + ": error: is no HDF5 file\n");
  EXPECT_EQ(readHdf5(scratch.path("missing.h5")).problems.text(),
            scratch.path("missing.h5") + ": error: cannot be read: No such file or directory\n");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

// A copy that was cut short anywhere: a problem, never a crash, a hang or a print.
TEST(Hdf5Reader, FilesCutShortEndInAProblem) {
  const TestFolder scratch;
  writeHdf5(exampleRecord(), scratch.path("whole.h5"));
  const std::string whole = textOf(scratch.path("whole.h5"));
  ::testing::internal::CaptureStderr();
  for (std::size_t length = 8; length < whole.size(); length += whole.size() / 50) {
    scratch.file("cut.h5", whole.substr(0, length));
    const auto outcome = readHdf5(scratch.path("cut.h5"));
    EXPECT_FALSE(outcome.ok()) << "cut at " << length;
    EXPECT_FALSE(outcome.problems.empty()) << "cut at " << length;
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(HistoryFile, TheExtensionChoosesTheFormat) {
  const TestFolder scratch;
  const RunRecord record = exampleRecord();
  writeHistory(scratch.path("run.csv"), record);
  writeHistory(scratch.path("run.h5"), record);
  EXPECT_EQ(readCsv(scratch.path("run.csv")).orThrow().columns(), record.history.columns());
  EXPECT_EQ(readHdf5(scratch.path("run.h5")).orThrow().inputs, record.inputs);
}

TEST(HistoryFile, AnyOtherExtensionIsRefusedNamingBoth) {
  for (const std::string name : {"run.mat", "run", ".h5"}) {
    try {
      writeHistory(name, exampleRecord());
      ADD_FAILURE() << name << " was written";
    } catch (const std::invalid_argument& error) {
      const std::string extension = std::filesystem::path(name).extension().string();
      EXPECT_EQ(error.what(), name + ": extension \"" + extension + "\" is unknown; name it .csv (text) or .h5 (HDF5)");
    }
  }
}

}  // namespace
}  // namespace vehicle
