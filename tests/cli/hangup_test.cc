// A terminal that closes: SIGHUP ends a run as Ctrl-C does, unless it was ignored at the start.
#include <csignal>
#include <cstdint>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "libvehicle/storage/csv.h"
#include "tests/cli/studies.h"

namespace vehicle::test {
namespace {

/// The program has asked the system for the signals that it takes itself: it catches SIGTERM.
/// Source: proc(5), SigCgt: bit n - 1 stands for signal n.
bool catchesSignals(const RunningProgram& program) {
  std::istringstream status(textOf("/proc/" + std::to_string(program.process) + "/status"));
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with("SigCgt:")) continue;
    const std::uint64_t mask = std::stoull(line.substr(7), nullptr, 16);
    return ((mask >> (SIGTERM - 1)) & 1U) != 0;
  }
  return false;
}

void hangUp(pid_t process) { kill(process, SIGHUP); }

TEST(Hangup, EndsALongRunAndKeepsWhatIsDone) {
  const TestFolder folder;
  const std::string scenario =
      folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="40000 s" output_step="10 ms")"));
  const ProgramRun run = runVehicle({"simulate", folder.file("v.xml", smallVehicle()), scenario, "--form", "mbs",
                                     "--method", "rk4", "--output", folder.path("run.csv")},
                                    showsProgress, hangUp);
  EXPECT_EQ(run.status, 130) << run.err;
  EXPECT_TRUE(has(run.err, "vehicle: interrupted at t = ")) << run.err;
  EXPECT_GT(readCsv(folder.path("run.csv")).orThrow().samples(), 1u);
  EXPECT_EQ(folder.entries(), 3u);
}

TEST(Hangup, EndsNoRunThatIgnoresItAsUnderNohup) {
  const TestFolder folder;
  const std::string scenario =
      folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="20 s" output_step="5 ms")"));
  const auto before = std::signal(SIGHUP, SIG_IGN);  // which a program that is started inherits
  const ProgramRun run = runVehicle(
      {"simulate", folder.file("v.xml", smallVehicle()), scenario, "--form", "mbs", "--method", "rk4"},
      catchesSignals, hangUp);
  std::signal(SIGHUP, before);
  EXPECT_EQ(run.status, 0) << run.err;
}

}  // namespace
}  // namespace vehicle::test
