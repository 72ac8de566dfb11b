// Every output of every command against everything that it must not destroy. A new option that names a file to write
// needs a row here: the table is held against the pages of --help.
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/storage/file_lock.h"
#include "tests/cli/output_table.h"
#include "tests/cli/studies.h"

namespace vehicle::test {
namespace {

namespace fs = std::filesystem;

void expectRefusal(const OutputFiles& files, const Output& output, const std::string& place,
                   const std::vector<std::string>& parts, bool overwrite) {
  const auto before = files.all();
  std::vector<std::string> words = {output.option, argumentFor(files, output)};
  if (overwrite) words.emplace_back("--overwrite");
  const ProgramRun run = files.run(output, words);
  EXPECT_EQ(run.status, 2) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(linesOf(run.err).size(), 1u) << run.err;
  EXPECT_TRUE(has(run.err, output.option)) << run.err;
  EXPECT_TRUE(has(run.err, place)) << run.err;
  for (const std::string& part : parts) EXPECT_TRUE(has(run.err, part)) << part << " is not in " << run.err;
  EXPECT_TRUE(files.all() == before) << "something was touched";
}

TEST(Outputs, OfEveryCommandStandInTheTableOfThisTest) {
  std::set<std::string> known;
  for (const Output& each : outputs()) known.insert(std::string(each.command) + ' ' + each.option);
  std::set<std::string> found;
  for (const std::string& line : linesOf(runVehicle({"--help"}).out)) {
    if (!line.starts_with("  ") || line[2] == ' ' || line[2] == '-') continue;
    const std::string command = line.substr(2, line.find(' ', 2) - 2);
    for (const std::string& option : linesOf(runVehicle({command, "--help"}).out)) {
      const bool names_file = has(option, " FILE ") || has(option, " FOLDER ");
      if (option.starts_with("  --") && names_file) {
        found.insert(command + ' ' + option.substr(2, option.find(' ', 2) - 2));
      }
    }
  }
  EXPECT_EQ(found, known);
}

TEST(Outputs, NeverReplaceAnInputADatabaseOrItsCompanionByWhateverName) {
  for (const Output& output : outputs()) {
    for (const std::string& kept : keptBy(output)) {
      for (const bool hard : {false, true}) {
        SCOPED_TRACE(std::string(output.name) + " on " + kept + (hard ? ", hard link" : ", symbolic link"));
        const OutputFiles files;
        const std::string place = placeOf(files, output);
        if (hard && !fs::exists(files.path(kept))) continue;  // only what is there can have a second name
        if (hard) {
          fs::create_hard_link(files.path(kept), place);
        } else {
          fs::create_symlink(kept, place);
        }
        // Each with one of the two: --overwrite makes no difference to an input.
        expectRefusal(files, output, place, {files.path(kept)}, hard);
      }
    }
  }
}

TEST(Outputs, NeverReplaceEachOther) {
  const OutputFiles files;
  const std::string a = files.path("a.csv"), again = files.path("./a.csv");
  const Output simulate = outputs()[0];
  struct Pair {
    Output output;
    std::vector<std::string> words;
    std::string message;
  };
  fs::create_symlink("b.json", files.path("t.svg"));
  fs::create_symlink("new.csv", files.path("new.sqlite"));
  const std::vector<Pair> pairs = {
      {simulate, {"--output", a, "--output", a}, "--output " + a + " is given twice"},
      {simulate, {"--output", a, "--output", again}, "--output " + again + " is the same file as --output " + a},
      {outputs()[2],
       {"--trace", files.path("b.json"), "--timeline", files.path("t.svg")},
       "--timeline " + files.path("t.svg") + " is the same file as --trace " + files.path("b.json")},
      {outputs()[5],
       {"--export", files.path("new.csv")},
       "--export " + files.path("new.csv") + " is the same file as --output " + files.path("new.sqlite")},
      {outputs()[5],
       {"--export", files.path("x.csv"), "--write-best", files.path("x.csv")},
       "--write-best " + files.path("x.csv") + " is the same file as --export " + files.path("x.csv")},
  };
  const auto before = files.all();
  for (const Pair& pair : pairs) {
    const ProgramRun run = files.run(pair.output, pair.words);
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_EQ(run.err, "vehicle: " + pair.message + (has(pair.message, "twice") ? "\n" : "; name another file\n"));
    EXPECT_TRUE(files.all() == before);
  }
}

TEST(Outputs, OfAnotherEndingAreRefused) {
  for (const Output& output : outputs()) {
    if (*output.ending == '\0') continue;
    const OutputFiles files;
    const auto before = files.all();
    for (const char* name : {"out", "out.xml", "out.sqlite-wal", ".csv", ""}) {
      SCOPED_TRACE(std::string(output.name) + " named " + name);
      const std::string place = *name != '\0' ? files.path(name) : "";
      const ProgramRun run = files.run(output, {output.option, place, "--overwrite"});
      EXPECT_EQ(run.status, 2) << run.err;
      EXPECT_TRUE(has(run.err, std::string(output.option) + ' ' + place + ": extension \"")) << run.err;
      EXPECT_TRUE(has(run.err, "name it ")) << run.err;
      EXPECT_TRUE(files.all() == before);
    }
  }
}

TEST(Outputs, LeaveAForeignFileUnlessTheyMayOverwriteIt) {
  for (const Output& output : outputs()) {
    SCOPED_TRACE(output.name);
    const OutputFiles files;
    const std::string place = placeOf(files, output);
    files.file(fs::path(place).filename().string(), "my own notes\n");
    expectRefusal(files, output, place, {"--overwrite"}, false);
    if (std::string(output.name) == "study --output") {
      expectRefusal(files, output, place, {"is no database of a study"}, true);
      continue;
    }
    const ProgramRun run = files.run(output, {output.option, argumentFor(files, output), "--overwrite"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(textOf(place), "my own notes\n");
  }
}

TEST(Outputs, AreNoFoldersAndNeedAPlaceThatCanBeWritten) {
  for (const Output& output : outputs()) {
    SCOPED_TRACE(output.name);
    const OutputFiles files;
    const std::string place = placeOf(files, output);
    fs::create_directory(place);
    expectRefusal(files, output, place, {"is a folder"}, true);
    fs::remove(place);
    const auto before = files.all();
    const std::string nowhere = *output.ending != '\0' ? std::string("/proc/out") + output.ending : "/proc/best";
    const ProgramRun run = files.run(output, {output.option, nowhere});
    EXPECT_EQ(run.status, 3) << run.err;
    EXPECT_TRUE(has(run.err, nowhere)) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_TRUE(files.all() == before);
  }
}

TEST(Outputs, ReplaceEmptyFilesAndThoseOfEarlierRunsWithEndingsInAnyLetterCase) {
  for (const Output& output : outputs()) {
    SCOPED_TRACE(output.name);
    const OutputFiles files;
    std::string place = placeOf(files, output);
    if (*output.ending != '\0') {
      place = files.path("OUT");
      for (const char* letter = output.ending; *letter != '\0'; ++letter)
        place += static_cast<char>(std::toupper(*letter));
    }
    const std::string argument = *output.ending != '\0' ? place : argumentFor(files, output);
    files.file(fs::path(place).filename().string(), "");
    const ProgramRun first = files.run(output, {output.option, argument});
    ASSERT_EQ(first.status, 0) << first.err;
    EXPECT_GT(fs::file_size(place), 0u);
    fs::remove(files.path("new.sqlite"));
    const bool is_database = std::string(output.name) == "study --output";
    const ProgramRun second = files.run(output, {output.option, argument, is_database ? "--overwrite" : "--quiet"});
    EXPECT_EQ(second.status, 0) << second.err;
    for (const auto& [name, text] : files.all()) {
      EXPECT_FALSE(has(name, "vehicle-tmp") || name.ends_with("-lock") || name.ends_with("-wal")) << name;
    }
  }
}

TEST(Outputs, AStudyIsBegunAnewOnlyWhereNobodyWritesIt) {
  const OutputFiles files;
  const Output output = outputs()[4];
  const auto before = files.all();
  {
    const FileLock writer(files.path("done.sqlite"));
    const ProgramRun run = files.run(output, {"--output", files.path("done.sqlite"), "--overwrite"});
    EXPECT_EQ(run.status, 3) << run.err;
    EXPECT_EQ(run.err, "vehicle: " + files.path("done.sqlite") + ": another process is writing it; wait for its end\n");
  }
  EXPECT_TRUE(files.all() == before);
  EXPECT_EQ(files.run(output, {"--output", files.path("done.sqlite")}).status, 2);
  const ProgramRun run = files.run(output, {"--output", files.path("done.sqlite"), "--overwrite"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(has(run.out, "\nevaluated now  6\n")) << run.out;
}

// SQLite reads such names as URIs; a file is called so by whoever has another program that makes them.
TEST(Outputs, OfAStudyMayBeCalledAsAUri) {
  const OutputFiles files;
  const fs::path before = fs::current_path();
  fs::current_path(files.path("."));
  const std::string name = "file:x.sqlite";
  const ProgramRun run = runVehicle({"study", "study.xml", "--output", name});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(runVehicle({"study", "show", name, "--export", "file:x.csv"}).status, 0);
  fs::current_path(before);
  EXPECT_TRUE(fs::is_regular_file(files.path(name)));
  EXPECT_TRUE(fs::is_regular_file(files.path("file:x.csv")));
  EXPECT_FALSE(fs::exists(files.path("x.sqlite")));
  for (const auto& [kept, text] : files.all()) EXPECT_FALSE(has(kept, "vehicle-tmp")) << kept;
}

TEST(Outputs, OfTheBestDesignsAreAllWrittenOrNone) {
  const OutputFiles files;
  files.file("best/carbody-az-rms-3.xml", "<vehicle name=\"mine\"/>\n");
  const auto before = files.all();
  const ProgramRun run = runVehicle({"study", "show", files.path("done.sqlite"), "--write-best", files.path("best")});
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(has(run.err, files.path("best/carbody-az-rms-3.xml"))) << run.err;
  EXPECT_TRUE(files.all() == before);
}

}  // namespace
}  // namespace vehicle::test
