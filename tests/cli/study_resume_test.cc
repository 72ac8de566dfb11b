// Studies that end before their end: Ctrl-C, a full disk, a kill; and the tables that any way to the end gives.
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cli/studies.h"

namespace vehicle::test {
namespace {

/// Quick designs: a hundred thousand a second and more on any machine of today.
std::string quickStudy(int designs) {
  return paperStudy(R"(<vary parameter="carbody.mass" from="40 t" to="70 t"/>
  <vary parameter="secondary.stiffness_z" kind="relative" from="50 %" to="200 %"/>
  <plan kind="sobol" size=")" + std::to_string(designs) + R"("/>)");
}

/// Modes take a fraction of a millisecond a design.
std::string slowStudy(int designs) {
  return with(quickStudy(designs), "</study>", "  <metric name=\"mode.carbody bounce.damping\"/>\n</study>");
}

std::string exported(const TestFolder& folder, const std::string& database) {
  const std::string csv = folder.path("table.csv");
  EXPECT_EQ(runVehicle({"study", "show", database, "--export", csv, "--quiet"}).status, 0);
  return textOf(csv);
}

TEST(StudyResume, AnyNumberOfThreadsExportsTheSameBytes) {
  const TestFolder folder;
  const std::string study = folder.file("study.xml", slowStudy(500));
  std::vector<std::string> tables;
  for (const char* jobs : {"1", "2", "5"}) {
    const std::string name = std::string("with-").append(jobs);
    const ProgramRun run = runVehicle({"study", study, "--output", folder.path(name + ".sqlite"), "--export",
                                       folder.path(name + ".csv"), "--jobs", jobs});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "written: " + folder.path(name + ".csv") + "\n");
    EXPECT_TRUE(has(run.out, std::string("\nthreads        ").append(jobs).append("\n"))) << run.out;
    tables.push_back(textOf(folder.path(name + ".csv")));
  }
  EXPECT_EQ(linesOf(tables[0]).size(), 502u);  // header, base, plan
  EXPECT_EQ(linesOf(tables[0])[0],
            "id,design,status,carbody.mass [kg],secondary.stiffness_z [N/m],carbody.az.rms [m/s^2],"
            "mode.carbody bounce.damping [],warnings,message");
  EXPECT_EQ(tables[1], tables[0]);
  EXPECT_EQ(tables[2], tables[0]);
}

TEST(StudyResume, CtrlCKeepsWhatIsDoneAndTheCommandItNamesGivesTheTableOfAnUninterruptedRun) {
  const TestFolder folder;
  const std::string study = folder.file("study.xml", slowStudy(4000));
  const std::string whole = folder.path("whole.sqlite");
  ASSERT_EQ(runVehicle({"study", study, "--output", whole, "--quiet"}).status, 0);
  const std::string database = folder.path("it's.sqlite");
  const ProgramRun run = runVehicle({"study", study, "--output", database, "--jobs", "1"}, hasComputedSince(database),
                                    [](pid_t process) { kill(process, SIGINT); });
  ASSERT_EQ(run.status, 130) << run.err;
  EXPECT_EQ(run.err.rfind("vehicle: interrupted; ", 0), 0u) << run.err;
  const std::string command =
      "  vehicle study " + study + " --output '" + folder.path("it'\\''s.sqlite") + "' --resume\n";
  EXPECT_TRUE(run.err.ends_with(" of 4001 designs are kept. Go on with:\n" + command)) << run.err;
  EXPECT_TRUE(has(run.out, "comparison")) << run.out;
  const ProgramRun rest = runVehicle({"study", study, "--output", database, "--resume"});
  ASSERT_EQ(rest.status, 0) << rest.err;
  EXPECT_FALSE(has(rest.out, "\nevaluated now  4001\n")) << rest.out;
  EXPECT_TRUE(exported(folder, database) == exported(folder, whole));
  const ProgramRun again = runVehicle({"study", study, "--output", database, "--resume"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_TRUE(has(again.out, "\nevaluated now  0\n")) << again.out;
}

TEST(StudyResume, AKilledStudyGoesOnToTheSameTable) {
  const TestFolder folder;
  const std::string study = folder.file("study.xml", quickStudy(100'000));
  const std::string whole = folder.path("whole.sqlite"), killed = folder.path("killed.sqlite");
  ASSERT_EQ(runVehicle({"study", study, "--output", whole, "--quiet"}).status, 0);
  static_cast<void>(runVehicle({"study", study, "--output", killed}, hasComputedSince(killed),
                               [](pid_t process) { kill(process, SIGKILL); }));
  const ProgramRun rest = runVehicle({"study", study, "--output", killed, "--resume", "--quiet"});
  ASSERT_EQ(rest.status, 0) << rest.err;
  EXPECT_TRUE(exported(folder, killed) == exported(folder, whole));
}

/// No file of a program that is started may grow beyond this, as on a disk that is full.
class LargestFile {
 public:
  explicit LargestFile(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit now = before_;
    now.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &now);
  }
  ~LargestFile() { setrlimit(RLIMIT_FSIZE, &before_); }
  LargestFile(const LargestFile&) = delete;
  LargestFile& operator=(const LargestFile&) = delete;

 private:
  rlimit before_ = {};
};

TEST(StudyResume, WhereNoMoreCanBeWrittenWhatIsStoredStaysAndItGoesOnLater) {
  const TestFolder folder;
  const std::string study = folder.file("study.xml", quickStudy(60'000));
  const std::string whole = folder.path("whole.sqlite"), full = folder.path("full.sqlite");
  ASSERT_EQ(runVehicle({"study", study, "--output", whole, "--quiet"}).status, 0);
  ProgramRun run;
  {
    const LargestFile limit(std::filesystem::file_size(whole) / 2);
    run = runVehicle({"study", study, "--output", full});
  }
  EXPECT_EQ(run.status, 3) << run.err;
  EXPECT_EQ(run.err.rfind("vehicle: " + full + ": cannot be written: ", 0), 0u) << run.err;
  EXPECT_TRUE(run.err.ends_with("; what was stored before is safe; make room and go on with it. Go on with:\n" +
                                ("  vehicle study " + study + " --output " + full + " --resume\n")))
      << run.err;
  const ProgramRun shown = runVehicle({"study", "show", full});
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_FALSE(has(shown.out, "\nevaluated   0\n")) << shown.out;
  EXPECT_FALSE(has(shown.out, "\nevaluated   60001\n")) << shown.out;
  ASSERT_EQ(runVehicle({"study", study, "--output", full, "--resume", "--quiet"}).status, 0);
  EXPECT_TRUE(exported(folder, full) == exported(folder, whole));
}

TEST(StudyResume, AnExportThatDoesNotFitLeavesTheDatabaseAndNoHalfFile) {
  const TestFolder folder;
  const std::string study = folder.file("study.xml", quickStudy(20'000));
  const std::string database = folder.path("study.sqlite"), csv = folder.path("study.csv");
  ASSERT_EQ(runVehicle({"study", study, "--output", database, "--quiet"}).status, 0);
  ProgramRun run;
  {
    const LargestFile limit(100'000);
    run = runVehicle({"study", "show", database, "--export", csv});
  }
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.err.rfind("vehicle: " + csv + ": cannot be written: File too large", 0), 0u) << run.err;
  EXPECT_TRUE(has(run.out, "comparison")) << run.out;
  EXPECT_EQ(folder.entries(), 2u);  // the study and its database
  EXPECT_EQ(linesOf(exported(folder, database)).size(), 20'002u);
}

}  // namespace
}  // namespace vehicle::test
