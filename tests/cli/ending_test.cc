#include <sys/wait.h>

#include <chrono>
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
  const auto end = [](int process) { kill(process, SIGTERM); };
  const ProgramRun run = runVehicle({"simulate", folder.file("v.xml", smallVehicle()), scenario, "--form", "mbs",
                                     "--method", "rk4", "--output", folder.path("run.csv")},
                                    end, std::chrono::milliseconds(800));
  EXPECT_EQ(run.status, 130) << run.err;
  EXPECT_TRUE(has(run.err, "vehicle: interrupted at t = ")) << run.err;
  EXPECT_GT(readCsv(folder.path("run.csv")).orThrow().samples(), 1u);
}

TEST(Ending, CtrlCEndsACommandThatKeepsNothingAtOnce) {
  // The modes of 200 vehicles take half a minute, and nobody looks for a signal meanwhile.
  const TestFolder folder;
  const std::string train = folder.file("t.xml", "<train name=\"long\" format=\"1\">\n  <vehicle file=\"" +
                                                     model("vehicles/al-oraiqat-2017.xml") +
                                                     "\" count=\"200\" spacing=\"16 m\"/>\n</train>\n");
  std::chrono::steady_clock::time_point asked;
  const auto interrupt = [&](int process) {
    asked = std::chrono::steady_clock::now();
    kill(process, SIGINT);
  };
  const ProgramRun run = runVehicle({"modes", train}, interrupt, std::chrono::milliseconds(500));
  EXPECT_EQ(run.status, 128 + SIGINT) << run.err;
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(5));
}

TEST(Ending, AFullDiskUnderStdoutIsAFailureForHelpToo) {
  for (const char* words : {"--help", "--version", "study --help", "schema"}) {
    const int state = std::system((std::string(VEHICLE_PROGRAM) + " " + words + " > /dev/full 2> /dev/null").c_str());
    EXPECT_EQ(WEXITSTATUS(state), 3) << words;
  }
}

}  // namespace
}  // namespace vehicle::test
