// What a command may write, decided before it works: identities of files, kinds of outputs, refusals.
#include "libvehicle/storage/output_guard.h"

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/storage/csv.h"
#include "libvehicle/storage/file_lock.h"
#include "libvehicle/storage/hdf5.h"
#include "libvehicle/storage/study_database.h"
#include "tests/storage/studies.h"
#include "tests/support/test_folder.h"

namespace vehicle::test {
namespace {

namespace fs = std::filesystem;

/// The refusal of a guard, "" where there is none.
std::string refusalOf(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::invalid_argument& refusal) {
    return refusal.what();
  } catch (const RunFailed& failure) {
    return std::string("failed: ") + failure.what();
  }
  return "";
}

RunRecord smallRun() {
  RunRecord record{
      TimeHistory(std::vector<Channel>{{"carbody.z", "m"}}), {{"version", "1"}}, {{"v.xml", "<vehicle/>"}}};
  record.history.append(0.0)[1] = 1.0;
  return record;
}

TEST(FileIdentity, IsThatOfTheFileByWhateverNameItIsReached) {
  const TestFolder folder;
  const std::string file = folder.file("sub/a.csv", "x");
  fs::create_symlink("sub/a.csv", folder.path("soft.csv"));
  fs::create_hard_link(file, folder.path("hard.csv"));
  fs::create_directory_symlink("sub", folder.path("linked"));
  for (const std::string& name : {folder.path("soft.csv"), folder.path("hard.csv"), folder.path("sub/../sub/./a.csv"),
                                  folder.path("linked/a.csv"), fs::relative(file).string()}) {
    EXPECT_EQ(identityOf(name), identityOf(file)) << name;
  }
  EXPECT_NE(identityOf(folder.file("b.csv", "x")), identityOf(file));
}

TEST(FileIdentity, OfAFileThatIsNotThereIsItsNameInItsFolder) {
  const TestFolder folder;
  fs::create_directory(folder.path("sub"));
  fs::create_directory_symlink("sub", folder.path("linked"));
  fs::create_symlink("sub/new.csv", folder.path("dangling.csv"));
  fs::create_symlink("dangling.csv", folder.path("twice.csv"));
  const FileIdentity none = identityOf(folder.path("sub/new.csv"));
  for (const char* name : {"linked/new.csv", "sub/../sub/new.csv", "dangling.csv", "twice.csv"}) {
    EXPECT_EQ(identityOf(folder.path(name)), none) << name;
  }
  for (const char* name : {"new.csv", "sub/other.csv", "sub/new.csv/more", "sub"}) {
    EXPECT_NE(identityOf(folder.path(name)), none) << name;
  }
  EXPECT_EQ(identityOf(folder.path("a/b/c.csv")), identityOf(folder.path("a/b/c.csv")));
  EXPECT_NE(identityOf(folder.path("a/b/c.csv")), identityOf(folder.path("b/c.csv")));
}

TEST(OutputKind, IsRecognisedByWhatTheProgramWrites) {
  const TestFolder folder;
  const RunRecord run = smallRun();
  writeCsv(run.history, folder.path("run.csv"));
  writeHdf5(run, folder.path("run.h5"));
  {
    const StudyDatabase database = StudyDatabase::create(folder.path("study.sqlite"), smallStudy());
    database.writeCsv(folder.path("named.csv"), [](std::uint64_t) { return std::string("base"); });
    database.writeCsv(folder.path("plain.csv"));
  }
  const std::vector<std::pair<std::string, OutputKind>> ours = {
      {folder.path("run.csv"), OutputKind::kHistory},
      {folder.path("run.h5"), OutputKind::kHistory},
      {folder.path("study.sqlite"), OutputKind::kDatabase},
      {folder.path("named.csv"), OutputKind::kStudyTable},
      {folder.path("plain.csv"), OutputKind::kStudyTable},
      {folder.file("a.svg", "<svg>\n" + std::string(kTimelineMark) + "</svg>\n"), OutputKind::kTimeline},
      {folder.file("a.json", "{" + std::string(kTraceMark) + "}"), OutputKind::kTrace},
      {folder.file("a.xml", std::string(kVehicleMark) + "\n<vehicle/>"), OutputKind::kVehicle},
  };
  for (const auto& [path, kind] : ours) {
    for (const OutputKindInfo& each : outputKinds()) EXPECT_EQ(isOurs(path, each.kind), each.kind == kind) << path;
  }
  const std::vector<std::string> foreign = {
      folder.file("measured.csv", "t,a\n0,1\n"),
      folder.file("time.csv", "time [s]x,a\n"),
      folder.file("design.csv", "design,mass\n"),
      folder.file("text.h5", "no HDF5"),
      folder.file("other.sqlite", "SQLite format 3" + std::string(200, '\0')),
      folder.file("other.xml", "<vehicle name=\"a\"/>"),
      folder.file("none", ""),
      folder.path("missing.csv"),
  };
  for (const std::string& path : foreign) {
    for (const OutputKindInfo& each : outputKinds()) EXPECT_FALSE(isOurs(path, each.kind)) << path << ' ' << each.name;
  }
  EXPECT_TRUE(isSqlite(folder.path("other.sqlite")));
}

TEST(OutputGuard, RefusesAnInputByEveryNameBeforeAndAfterItIsKnown) {
  const TestFolder folder;
  const std::string input = folder.file("v.xml", "<vehicle/>");
  fs::create_symlink("v.xml", folder.path("soft.csv"));
  fs::create_hard_link(input, folder.path("hard.h5"));
  for (const char* name : {"soft.csv", "hard.h5", "v.xml", "./v.xml"}) {
    const std::string output = folder.path(name);
    for (const Overwrite overwrite : {Overwrite::kOwnFiles, Overwrite::kAnyFile}) {
      const std::string message =
          "--output " + output + " is the same file as the vehicle file " + input + "; name another file";
      EXPECT_EQ(refusalOf([&] {
                  OutputGuard guard(overwrite);
                  guard.protect(input, "the vehicle file");
                  guard.claim(output, "--output", OutputKind::kHistory);
                }),
                message);
    }
  }
  EXPECT_EQ(
      refusalOf([&] {
        OutputGuard guard(Overwrite::kAnyFile);
        guard.claim(folder.path("hard.h5"), "--output", OutputKind::kHistory);
        guard.protect(input, "the vehicle file");
      }),
      "--output " + folder.path("hard.h5") + " is the same file as the vehicle file " + input + "; name another file");
  EXPECT_EQ(textOf(input), "<vehicle/>");
}

TEST(OutputGuard, AFileMayBeReadTwice) {
  const TestFolder folder;
  const std::string input = folder.file("v.xml", "<vehicle/>");
  OutputGuard guard;
  guard.protect(input, "the vehicle file");
  EXPECT_NO_THROW(guard.protect(input, "the scenario file"));
}

TEST(OutputGuard, RefusesTwoOutputsOfOneFile) {
  const TestFolder folder;
  const std::string path = folder.path("a.csv");
  const auto second = [&](const std::string& again, const char* option) {
    return refusalOf([&] {
      OutputGuard guard;
      guard.claim(path, "--output", OutputKind::kHistory);
      guard.claim(again, option, OutputKind::kHistory);
    });
  };
  EXPECT_EQ(second(path, "--output"), "--output " + path + " is given twice");
  const std::string other = folder.path("./a.csv");
  EXPECT_EQ(second(other, "--output"),
            "--output " + other + " is the same file as --output " + path + "; name another file");
  EXPECT_EQ(second(path, "--export"),
            "--export " + path + " is the same file as --output " + path + "; name another file");
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(OutputGuard, RefusesAForeignFileUnlessItMayBeOverwritten) {
  const TestFolder folder;
  const std::string measured = folder.file("measured.csv", "t,a\n");
  const auto claim = [&](Overwrite overwrite) {
    return refusalOf([&] { OutputGuard(overwrite).claim(measured, "--output", OutputKind::kHistory); });
  };
  EXPECT_EQ(claim(Overwrite::kOwnFiles), "--output " + measured +
                                             ": exists and is no time history that this program "
                                             "wrote; name another file, or replace it by "
                                             "--overwrite");
  EXPECT_EQ(claim(Overwrite::kAnyFile), "");
  EXPECT_EQ(textOf(measured), "t,a\n");
  OutputGuard guard;
  EXPECT_NO_THROW(guard.claim(folder.file("empty.csv", ""), "--output", OutputKind::kHistory));
}

TEST(OutputGuard, RefusesOtherEndingsFoldersDevicesAndPlacesThatCannotBeWritten) {
  const TestFolder folder;
  fs::create_directory(folder.path("folder.csv"));
  fs::create_symlink("/dev/null", folder.path("null.csv"));
  const auto claim = [&](const std::string& path) {
    return refusalOf([&] { OutputGuard(Overwrite::kAnyFile).claim(path, "--export", OutputKind::kStudyTable); });
  };
  EXPECT_EQ(claim("a.txt"), "--export a.txt: extension \".txt\" is unknown; name it .csv (text)");
  EXPECT_EQ(claim(".csv"), "--export .csv: extension \"\" is unknown; name it .csv (text)");
  EXPECT_EQ(claim(""), "--export : extension \"\" is unknown; name it .csv (text)");
  EXPECT_EQ(claim(folder.path("A.CSV")), "");
  EXPECT_EQ(claim(folder.path("folder.csv")),
            "--export " + folder.path("folder.csv") + ": is a folder; name a file in it");
  EXPECT_EQ(claim(folder.path("null.csv")),
            "--export " + folder.path("null.csv") + ": is a device or pipe; name a regular file");
  EXPECT_TRUE(claim(folder.path("no/where.csv")).starts_with("failed: ")) << claim(folder.path("no/where.csv"));
  EXPECT_EQ(folder.entries(), 2u);
}

TEST(OutputGuard, KeepsADatabaseAndItsCompanions) {
  const TestFolder folder;
  const std::string database = folder.path("study.sqlite");
  static_cast<void>(StudyDatabase::create(database, smallStudy()));
  for (const char* ending : {"", "-wal", "-shm", "-journal", "-lock"}) {
    const std::string link = folder.path("t.csv");
    fs::remove(link);
    fs::create_symlink(database + ending, link);
    const std::string refusal = refusalOf([&] {
      OutputGuard guard(Overwrite::kAnyFile);
      guard.protectDatabase(database, "the database");
      guard.claim(link, "--export", OutputKind::kStudyTable);
    });
    EXPECT_TRUE(refusal.starts_with("--export " + link + " is the same file as ")) << refusal;
    EXPECT_NE(refusal.find(database + ending), std::string::npos) << refusal;
    // Of a database that the command does not know, too.
    if (*ending == '\0') continue;
    EXPECT_EQ(refusalOf([&] { OutputGuard(Overwrite::kAnyFile).claim(link, "--export", OutputKind::kStudyTable); }),
              "--export " + link + ": is a companion of the database " + database + "; name another file");
  }
}

TEST(OutputGuard, ANewDatabaseTakesNoFileOfTheUserAsItsCompanion) {
  const TestFolder folder;
  const std::string database = folder.path("study.sqlite");
  for (const char* ending : {"-wal", "-shm", "-journal", "-lock"}) {
    const std::string mine = folder.file(std::string("study.sqlite") + ending, "my notes");
    EXPECT_EQ(refusalOf([&] { OutputGuard(Overwrite::kAnyFile).claimDatabase(database, "--output"); }),
              "--output " + database + ": " + mine +
                  " is there and belongs to no database; move it away, or name "
                  "another file");
    EXPECT_EQ(textOf(mine), "my notes");
    EXPECT_EQ(refusalOf([&] {
                OutputGuard guard(Overwrite::kAnyFile);
                guard.protect(mine, "the vehicle file");
                guard.claimDatabase(database, "--output");
              }),
              mine + ", a companion of --output " + database + ", is the same file as the vehicle file " + mine +
                  "; name another file");
    fs::remove(mine);
  }
}

TEST(OutputGuard, AStudyIsBegunAnewOnlyOverAStudyThatNobodyWrites) {
  const TestFolder folder;
  const std::string database = folder.path("study.sqlite");
  static_cast<void>(StudyDatabase::create(database, smallStudy()));
  const auto claim = [&](const std::string& path, Overwrite overwrite) {
    return refusalOf([&] { OutputGuard(overwrite).claimDatabase(path, "--output"); });
  };
  EXPECT_EQ(claim(database, Overwrite::kOwnFiles),
            "--output: " + database +
                " exists already; go on with it by --resume, begin it anew by --overwrite, or "
                "name another file");
  EXPECT_EQ(claim(database, Overwrite::kAnyFile), "");
  {
    const FileLock writer(database);
    EXPECT_EQ(claim(database, Overwrite::kAnyFile),
              "failed: " + database + ": another process is writing it; wait for its end");
  }
  const std::string foreign = folder.file("foreign.sqlite", "SQLite format 3" + std::string(200, '\0'));
  EXPECT_EQ(claim(foreign, Overwrite::kAnyFile),
            "--output " + foreign +
                ": exists and is no database of a study, and --overwrite replaces nothing else; "
                "name another file");
  EXPECT_EQ(claim(folder.file("empty.sqlite", ""), Overwrite::kOwnFiles), "");
  EXPECT_EQ(refusalOf([&] { OutputGuard().resumeDatabase(database, "--output"); }), "");
  EXPECT_EQ(refusalOf([&] { OutputGuard().resumeDatabase(folder.path("new.sqlite"), "--output"); }), "");
  EXPECT_EQ(folder.entries(), 3u);
}

TEST(OutputGuard, LooksAtEveryFileOfAFolderAndMakesNone) {
  const TestFolder folder;
  const std::string best = folder.path("a/best");
  const auto claim = [&](const std::string& path, Overwrite overwrite = Overwrite::kOwnFiles) {
    return refusalOf([&] {
      OutputGuard guard(overwrite);
      guard.protect(folder.path("v.xml"), "the vehicle file");
      guard.claimFolder(path, "--write-best", OutputKind::kVehicle, {"v.xml", "w.xml"});
    });
  };
  EXPECT_EQ(claim(best), "");
  EXPECT_EQ(folder.entries(), 0u);
  folder.file("a/best/w.xml", "<vehicle/>");
  EXPECT_EQ(claim(best), "--write-best " + folder.path("a/best/w.xml") +
                             ": exists and is no vehicle of a study that this program wrote; name another file, or "
                             "replace it by --overwrite");
  EXPECT_EQ(claim(best, Overwrite::kAnyFile), "");
  folder.file("v.xml", "<vehicle/>");
  const std::string root = folder.root().string();
  EXPECT_EQ(claim(root, Overwrite::kAnyFile), "--write-best " + folder.path("v.xml") +
                                                  " is the same file as the vehicle file " + folder.path("v.xml") +
                                                  "; name another file");
  EXPECT_EQ(claim(folder.path("v.xml")), "--write-best " + folder.path("v.xml") + ": is a file; name a folder");
  EXPECT_TRUE(claim(folder.path("v.xml/in")).starts_with("failed: "));
  EXPECT_EQ(refusalOf([&] {
              OutputGuard guard;
              guard.claim(folder.path("t.csv"), "--export", OutputKind::kStudyTable);
              guard.claimFolder(folder.path("t.csv/best"), "--write-best", OutputKind::kVehicle, {"w.xml"});
            }),
            "--write-best " + folder.path("t.csv/best") + " is the same file as --export " + folder.path("t.csv") +
                "; name another file");
}

}  // namespace
}  // namespace vehicle::test
