#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "libvehicle/storage/csv.h"
#include "tests/cli/program.h"

/// How the program ends when it is asked to, and when nobody takes what it says.
namespace vehicle::test {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Ending, SigtermEndsALongRunAsCtrlCDoesAndKeepsWhatIsDone) {
  const TestFolder folder;
  const std::string scenario =
      folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="40000 s" output_step="10 ms")"));
  const ProgramRun run = runVehicle({"simulate", folder.file("v.xml", smallVehicle()), scenario, "--form", "mbs",
                                     "--method", "rk4", "--output", folder.path("run.csv")},
                                    showsProgress, [](pid_t process) { kill(process, SIGTERM); });
  EXPECT_EQ(run.status, 130) << run.err;
  EXPECT_TRUE(has(run.err, "vehicle: interrupted at t = ")) << run.err;
  EXPECT_GT(readCsv(folder.path("run.csv")).orThrow().samples(), 1u);
}

TEST(Ending, CtrlCEndsACommandThatKeepsNothingAtOnce) {
  // The modes of 200 vehicles take half a minute of computing, and nobody looks for a signal meanwhile.
  const TestFolder folder;
  const std::string train = folder.file("t.xml", "<train name=\"long\" format=\"1\">\n  <vehicle file=\"" +
                                                     model("vehicles/al-oraiqat-2017.xml") +
                                                     "\" count=\"200\" spacing=\"16 m\"/>\n</train>\n");
  const ProgramRun run = runVehicle({"modes", train}, hasComputed, [](pid_t process) { kill(process, SIGINT); });
  // Killed by the signal: it neither came to its end nor had anything to print before it went.
  EXPECT_EQ(run.status, 128 + SIGINT) << run.err;
  EXPECT_EQ(run.out, "");
}

TEST(Ending, AFullDiskUnderStdoutIsAFailureForHelpToo) {
  for (const char* words : {"--help", "--version", "study --help", "schema"}) {
    const int state = std::system((programPath() + " " + words + " > /dev/full 2> /dev/null").c_str());
    EXPECT_EQ(WEXITSTATUS(state), 3) << words;
  }
}

}  // namespace
}  // namespace vehicle::test
