#include "libvehicle/storage/study_database.h"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "libvehicle/diagnostics/problem.h"
#include "tests/storage/studies.h"
#include "tests/support/test_folder.h"

namespace vehicle {
namespace {

using test::batchOf;
using test::hasFailed;
using test::metricsOfDesign;
using test::parametersOfDesign;
using test::refusalOf;
using test::smallStudy;
using test::TestFolder;
using test::textOf;

TEST(StudyDatabase, WhatIsStoredComesBackToTheSameBitsInTheOrderOfIds) {
  const TestFolder folder;
  const StudyRecord record = smallStudy();
  {
    StudyDatabase database = StudyDatabase::create(folder.path("study.sqlite"), record);
    database.append(batchOf(record, 500, 1000));
    database.append(batchOf(record, 0, 500));
  }
  const StudyDatabase database = StudyDatabase::read(folder.path("study.sqlite"));
  EXPECT_EQ(database.record(), record);
  EXPECT_EQ(database.stored(), 1000u);
  EXPECT_TRUE(database.missing().empty());
  std::uint64_t next = 0;
  database.forEach([&](const StoredDesign& design) {
    EXPECT_EQ(design.id, next);
    EXPECT_EQ(std::vector<double>(design.parameters.begin(), design.parameters.end()), parametersOfDesign(next));
    EXPECT_EQ(design.status == DesignStatus::kFailed, hasFailed(next));
    EXPECT_EQ(std::vector<double>(design.metrics.begin(), design.metrics.end()),
              hasFailed(next) ? std::vector<double>() : metricsOfDesign(next));
    EXPECT_EQ(design.message.empty(), !hasFailed(next));
    ++next;
    return true;
  });
  EXPECT_EQ(next, 1000u);
}

TEST(StudyDatabase, ExtremeNumbersKeepTheirBitsAndMinusZeroBecomesZero) {
  using Limits = std::numeric_limits<double>;
  const TestFolder folder;
  StudyRecord record = smallStudy(2);
  record.metrics.resize(4, {"m", ""});
  for (std::size_t i = 0; i < 4; ++i) record.metrics[i].name = std::string("m").append(std::to_string(i));
  StudyDatabase database = StudyDatabase::create(folder.path("study.sqlite"), record);
  DesignBatch batch(2, 4);
  const std::vector<double> extremes = {Limits::max(), -Limits::denorm_min(), 9007199254740993.0, 0.1};
  batch.add(0, parametersOfDesign(0), extremes);
  batch.add(1, std::vector<double>{-0.0, 1e300}, std::vector<double>{1.0, 2.0, 3.0, 4.0});
  database.append(batch);
  std::vector<double> read;
  database.forEach([&](const StoredDesign& design) {
    read.assign(design.metrics.begin(), design.metrics.end());
    if (design.id == 0) {
      EXPECT_EQ(read, extremes);
    } else {
      EXPECT_FALSE(std::signbit(design.parameters[0]));
    }
    return true;
  });
  EXPECT_EQ(read.back(), 4.0);
}

TEST(StudyDatabase, ADesignThatIsDoneMayLackValuesAndSaysWhy) {
  const TestFolder folder;
  const StudyRecord record = smallStudy(3);
  DesignBatch batch(2, 3);
  batch.add(0, parametersOfDesign(0), metricsOfDesign(0));
  batch.add(1, parametersOfDesign(1), std::vector<double>{1.0, std::nan(""), 3.0}, "no line in the band");
  batch.addFailed(2, parametersOfDesign(2), "weighs nothing");
  EXPECT_EQ(refusalOf(folder,
                      [&] {
                        batch.add(3, parametersOfDesign(3), std::vector<double>{1.0, std::nan(""), 3.0});
                      }),
            "DesignBatch: id 3 lacks a value without a message");
  StudyDatabase database = StudyDatabase::create(folder.path("study.sqlite"), record);
  database.append(batch);
  std::vector<std::string> seen;
  database.forEach([&](const StoredDesign& design) {
    std::string row(design.status == DesignStatus::kDone ? "done" : "failed");
    for (const double each : design.metrics) row.append(std::isnan(each) ? " -" : " x");
    seen.push_back(row.append(" ").append(design.message));
    return true;
  });
  EXPECT_EQ(seen, (std::vector<std::string>{"done x x x ", "done x - x no line in the band", "failed weighs nothing"}));
  // Any SQLite tool sees NULL, which is no number, and the CSV an empty field.
  database.writeCsv(folder.path("study.csv"));
  EXPECT_NE(textOf(folder.path("study.csv")).find(",1,,3,,no line in the band\n"), std::string::npos)
      << textOf(folder.path("study.csv"));
}

// Format 1 differs from format 2 in nothing but that no value is missing; the number stands at byte 60, big-endian (the
// format of SQLite's files, section 1.3).
TEST(StudyDatabase, AStudyOfAnOlderFormatIsShownButNotGoneOnWith) {
  const TestFolder folder;
  const StudyRecord record = smallStudy(10);
  const std::string path = folder.path("study.sqlite");
  StudyDatabase::create(path, record).append(batchOf(record, 0, 5));
  std::fstream(path, std::ios::in | std::ios::out | std::ios::binary).seekp(63).put(1);
  const StudyDatabase old = StudyDatabase::read(path);
  EXPECT_EQ(old.record(), record);
  EXPECT_EQ(old.stored(), 5u);
  EXPECT_EQ(
      refusalOf(folder, [&] { (void)StudyDatabase::resume(path, record); }),
      "study.sqlite: holds a study in format 1, which an older program wrote: it can be shown, but numbers of two "
      "programs are not mixed; write to a new file");
}

TEST(StudyDatabase, MissingIsTheComplementOfWhatIsStored) {
  const TestFolder folder;
  const StudyRecord record = smallStudy(100);
  StudyDatabase database = StudyDatabase::create(folder.path("study.sqlite"), record);
  EXPECT_EQ(database.missing(), (std::vector<DesignRange>{{0, 99}}));
  database.append(batchOf(record, 10, 20));
  database.append(batchOf(record, 20, 21));
  database.append(batchOf(record, 90, 100));
  EXPECT_EQ(database.missing(), (std::vector<DesignRange>{{0, 9}, {21, 89}}));
  database.append(batchOf(record, 0, 10));
  database.append(batchOf(record, 21, 90));
  EXPECT_TRUE(database.missing().empty());
  EXPECT_EQ(database.stored(), 100u);
}

TEST(StudyDatabase, ABatchThatIsRefusedLeavesNothingBehind) {
  const TestFolder folder;
  const StudyRecord record = smallStudy(100);
  StudyDatabase database = StudyDatabase::create(folder.path("study.sqlite"), record);
  database.append(batchOf(record, 0, 10));
  EXPECT_EQ(refusalOf(folder, [&] { database.append(batchOf(record, 5, 20)); }),
            "StudyDatabase: id 5 is stored already");
  DesignBatch twice = batchOf(record, 50, 60);
  test::addDesign(twice, 55);
  EXPECT_EQ(refusalOf(folder, [&] { database.append(twice); }), "StudyDatabase: id 55 is stored already");
  DesignBatch infinite = batchOf(record, 30, 35);
  infinite.add(36, parametersOfDesign(36), std::vector<double>{1.0, INFINITY, 2.0});
  EXPECT_EQ(refusalOf(folder, [&] { database.append(infinite); }),
            "StudyDatabase: id 36: carbody.az.rms @ 120 km/h = inf, must be finite, or NaN where there is no value");
  DesignBatch nowhere = batchOf(record, 30, 35);
  nowhere.add(36, std::vector<double>{1.0, std::nan("")}, metricsOfDesign(36));
  EXPECT_EQ(refusalOf(folder, [&] { database.append(nowhere); }),
            "StudyDatabase: id 36: primary.stiffness_z = nan, must be finite");
  EXPECT_EQ(refusalOf(folder, [&] { database.append(batchOf(record, 99, 101)); }),
            "StudyDatabase: id 100 of a study of 100 designs");
  EXPECT_EQ(database.stored(), 10u);
  database.append(batchOf(record, 10, 100));
  EXPECT_TRUE(database.missing().empty());
}

TEST(StudyDatabase, OnlyTheSameStudyGoesOnAndEveryChangedLineIsTold) {
  const TestFolder folder;
  const std::string path = folder.path("study.sqlite");
  const StudyRecord record = smallStudy();
  { StudyDatabase::create(path, record).append(batchOf(record, 0, 10)); }
  EXPECT_EQ(StudyDatabase::resume(path, record).missing(), (std::vector<DesignRange>{{10, 999}}));

  StudyRecord changed = record;
  changed.inputs[0].text = "<study>\n  <plan size=\"2000\"/>\n  <more/>\n</study>\n";
  changed.inputs[1].text = "";
  EXPECT_EQ(
      refusalOf(folder, [&] { static_cast<void>(StudyDatabase::resume(path, changed)); }),
      "study.xml:2: error: changed since study.sqlite was begun: the line was \"  <plan size=\"1000\"/>\" and is now "
      "\"  <plan size=\"2000\"/>\"\n"
      "study.xml:3: error: changed since study.sqlite was begun: the line \"  <more/>\" is new\n"
      "coach.xml:1: error: changed since study.sqlite was begun: the line \"<vehicle/>\" is gone\n"
      "study.sqlite: error: holds designs of the study as it was; bring the files back, or write to a new file\n");
  StudyRecord newer = record;
  newer.program = "vehicle 0.2.0";
  EXPECT_EQ(
      refusalOf(folder, [&] { static_cast<void>(StudyDatabase::resume(path, newer)); }),
      "study.sqlite: error: was begun by vehicle 0.1.0, this is vehicle 0.2.0: their numbers may differ in the last "
      "digits; go on with that program, or write to a new file\n");
  // The names of files may be given from another folder: they are the same files.
  StudyRecord moved = record;
  moved.inputs[1].name = "../coach.xml";
  EXPECT_EQ(refusalOf(folder, [&] { static_cast<void>(StudyDatabase::resume(path, moved)); }), "no refusal");
  // One file in the place of another is no file with other lines.
  StudyRecord replaced = record;
  replaced.inputs[1] = {"wagon.xml", "<vehicle name=\"wagon\"/>\n"};
  EXPECT_EQ(
      refusalOf(folder, [&] { static_cast<void>(StudyDatabase::resume(path, replaced)); }),
      "wagon.xml: error: was no part of the study when study.sqlite was begun\n"
      "coach.xml: error: was a part of the study when study.sqlite was begun\n"
      "study.sqlite: error: holds designs of the study as it was; bring the files back, or write to a new file\n");
}

TEST(StudyDatabase, AFileThatIsNoStudyIsRefusedAndLeftAlone) {
  const TestFolder folder;
  const StudyRecord record = smallStudy();
  const std::string path = folder.file("text.sqlite", std::string(2000, 'x'));
  EXPECT_EQ(refusalOf(folder, [&] { static_cast<void>(StudyDatabase::create(path, record)); }),
            "text.sqlite: exists already; go on with it, remove it, or name another file");
  for (const auto& open :
       std::vector<std::function<void()>>{[&] { static_cast<void>(StudyDatabase::resume(path, record)); },
                                          [&] { static_cast<void>(StudyDatabase::read(path)); }}) {
    EXPECT_EQ(refusalOf(folder, open),
              "text.sqlite: error: holds no study: it is no SQLite file; name a database that `vehicle study --output` "
              "wrote\n");
  }
  EXPECT_EQ(textOf(path), std::string(2000, 'x'));
  folder.file("empty.sqlite", "");
  EXPECT_EQ(refusalOf(folder, [&] { static_cast<void>(StudyDatabase::read(folder.path("empty.sqlite"))); }),
            "empty.sqlite: error: holds no study; name a database that this program's `vehicle study --output` "
            "wrote\n");
  EXPECT_EQ(refusalOf(folder, [&] { static_cast<void>(StudyDatabase::read(folder.path("none.sqlite"))); }),
            "none.sqlite: error: cannot be read: No such file or directory; check the name of the file\n");
  EXPECT_EQ(refusalOf(folder, [&] { static_cast<void>(StudyDatabase::read(folder.root())); })
                .substr(folder.root().string().size()),
            ": error: is a folder; name a file in it\n");
  EXPECT_EQ(
      refusalOf(folder, [&] { static_cast<void>(StudyDatabase::create(folder.path("no/where.sqlite"), record)); }),
      "no/where.sqlite: cannot be written: No such file or directory; its folder must exist and be writable");
}

TEST(StudyDatabase, OneProcessWritesWhileOthersRead) {
  const TestFolder folder;
  const std::string path = folder.path("study.sqlite");
  const StudyRecord record = smallStudy();
  {
    StudyDatabase database = StudyDatabase::create(path, record);
    database.append(batchOf(record, 0, 10));
    EXPECT_EQ(refusalOf(folder, [&] { static_cast<void>(StudyDatabase::resume(path, record)); }),
              "study.sqlite: another process is writing it; wait for its end");
    const StudyDatabase reader = StudyDatabase::read(path);
    EXPECT_EQ(reader.stored(), 10u);
    database.append(batchOf(record, 10, 20));
    EXPECT_EQ(reader.stored(), 20u);
    EXPECT_THROW(StudyDatabase::read(path).append(batchOf(record, 20, 30)), std::invalid_argument);
  }
  // Closed in order, the study is one file: no log, no lock.
  EXPECT_EQ(folder.entries(), 1u);
}

// A killed study leaves its log beside the file. Who removes the file alone and begins anew must not get the old
// designs played into the new table: SQLite does that, whatever the log belongs to.
TEST(StudyDatabase, TheLogOfARemovedStudyIsNotPlayedIntoTheNextOne) {
  const TestFolder folder;
  const std::string path = folder.path("study.sqlite");
  const std::string log = path + "-wal";
  {
    StudyDatabase database = StudyDatabase::create(path, smallStudy());
    database.append(batchOf(database.record(), 0, 1000));
    std::filesystem::copy_file(log, folder.path("kept"));
  }
  ASSERT_GT(std::filesystem::file_size(folder.path("kept")), 10'000u);
  std::filesystem::remove(path);
  std::filesystem::rename(folder.path("kept"), log);
  StudyRecord other = smallStudy(3);
  other.metrics.pop_back();
  StudyDatabase database = StudyDatabase::create(path, other);
  EXPECT_EQ(database.stored(), 0u);
  EXPECT_EQ(database.record().metrics, other.metrics);
  database.append(batchOf(other, 0, 3));
  EXPECT_EQ(StudyDatabase::read(path).stored(), 3u);
}

TEST(StudyDatabase, WrittenAndReadItIsOneFileAlone) {
  const TestFolder folder;
  const std::string path = folder.path("study.sqlite");
  {
    StudyDatabase database = StudyDatabase::create(path, smallStudy(10));
    database.append(batchOf(database.record(), 0, 10));
  }
  EXPECT_EQ(StudyDatabase::read(path).stored(), 10u);
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(StudyDatabase, AStudyOfTooManyColumnsIsRefusedAndTheMostThatFitAreStored) {
  const TestFolder folder;
  StudyRecord record = smallStudy(2);
  record.metrics.clear();
  for (int i = 0; i < 1995; ++i) record.metrics.push_back({std::string("m").append(std::to_string(i)), "m"});
  EXPECT_EQ(
      refusalOf(folder, [&] { static_cast<void>(StudyDatabase::create(folder.path("wide.sqlite"), record)); }),
      "study.xml:1: error: the study makes 1997 columns (2 parameters, 1995 metrics over all speeds and scenarios), at "
      "most 1996 fit in a row; ask for fewer metrics or speeds, or make two studies\n");
  EXPECT_EQ(folder.entries(), 0u);
  record.metrics.pop_back();
  StudyDatabase database = StudyDatabase::create(folder.path("wide.sqlite"), record);
  database.append(batchOf(record, 0, 2));
  EXPECT_EQ(database.stored(), 2u);
}

TEST(StudyDatabase, NamesThatDifferInCaseOrQuotesAreColumnsOfTheirOwn) {
  const TestFolder folder;
  StudyRecord record = smallStudy(1);
  record.parameters = {{"front.mass", "kg"}, {"Front.mass", "kg"}};
  record.metrics = {{"id", ""}, {"a \"b\"", "m"}, {"FRONT.mass", "kg"}};
  StudyDatabase database = StudyDatabase::create(folder.path("study.sqlite"), record);
  database.append(batchOf(record, 0, 1));
  EXPECT_EQ(database.record(), record);
  record.metrics[1].name = "id";
  EXPECT_THROW(static_cast<void>(StudyDatabase::create(folder.path("twice.sqlite"), record)), std::invalid_argument);
}

/// Runs `work` as a user without special rights: root may write everywhere.
std::string asOrdinaryUser(const std::function<std::string()>& work) {
  int ends[2];
  if (::pipe(ends) != 0) return "no pipe";
  const pid_t child = ::fork();
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (::geteuid() == 0 && ::setuid(kNobody) != 0) ::_exit(2);
    const std::string said = work();
    const bool told = ::write(ends[1], said.data(), said.size()) == static_cast<ssize_t>(said.size());
    ::_exit(told ? 0 : 1);
  }
  ::close(ends[1]);
  std::string said;
  char block[512];
  for (ssize_t got = 0; (got = ::read(ends[0], block, sizeof block)) > 0;)
    said.append(block, static_cast<std::size_t>(got));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  return said;
}

TEST(StudyDatabase, AFolderThatMayNotBeWrittenIsReadButNotWritten) {
  const TestFolder folder;
  const std::string path = folder.path("study?1%.sqlite");
  const StudyRecord record = smallStudy(10);
  { StudyDatabase::create(path, record).append(batchOf(record, 0, 10)); }
  ASSERT_EQ(::chmod(path.c_str(), 0444), 0);
  ASSERT_EQ(::chmod(folder.root().c_str(), 0555), 0);
  EXPECT_EQ(asOrdinaryUser([&] { return std::to_string(StudyDatabase::read(path).stored()); }), "10");
  EXPECT_EQ(asOrdinaryUser(
                [&] { return refusalOf(folder, [&] { static_cast<void>(StudyDatabase::resume(path, record)); }); }),
            "study?1%.sqlite: cannot be written: Permission denied; its folder must exist and be writable");
  EXPECT_EQ(asOrdinaryUser([&] {
              return refusalOf(folder,
                               [&] { static_cast<void>(StudyDatabase::create(folder.path("new.sqlite"), record)); });
            }),
            "new.sqlite: cannot be written: Permission denied; its folder must exist and be writable");
  ASSERT_EQ(::chmod(folder.root().c_str(), 0755), 0);
}

}  // namespace
}  // namespace vehicle
