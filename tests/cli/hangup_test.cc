// A terminal that closes, and one that may: SIGHUP ends a run as Ctrl-C does, unless it was ignored at the start.
#include <csignal>
#include <cstdint>
#include <sstream>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "libvehicle/storage/csv.h"
#include "tests/cli/studies.h"

namespace vehicle::test {
namespace {

/// Whether a process catches a signal by now; true too once it is gone, so that nobody waits for ever.
/// Source: proc(5), SigCgt: bit n - 1 stands for signal n.
bool catches(int process, int signal) {
  std::istringstream status(textOf("/proc/" + std::to_string(process) + "/status"));
  if (status.str().empty() || has(status.str(), "State:\tZ")) return true;
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with("SigCgt:")) continue;
    const std::uint64_t mask = std::stoull(line.substr(7), nullptr, 16);
    return ((mask >> (signal - 1)) & 1U) != 0;
  }
  return false;
}

void hangUp(int process) {
  while (!catches(process, SIGTERM)) std::this_thread::yield();
  kill(process, SIGHUP);
}

TEST(Hangup, EndsALongRunAndKeepsWhatIsDone) {
  const TestFolder folder;
  const std::string scenario =
      folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="40000 s" output_step="10 ms")"));
  const ProgramRun run = runVehicle({"simulate", folder.file("v.xml", smallVehicle()), scenario, "--form", "mbs",
                                     "--method", "rk4", "--output", folder.path("run.csv")},
                                    hangUp);
  EXPECT_EQ(run.status, 130) << run.err;
  EXPECT_TRUE(has(run.err, "vehicle: interrupted at t = ")) << run.err;
  EXPECT_GE(readCsv(folder.path("run.csv")).orThrow().samples(), 1u);
  EXPECT_EQ(folder.entries(), 3u);
}

TEST(Hangup, EndsNoRunThatIgnoresItAsUnderNohup) {
  const TestFolder folder;
  const std::string scenario =
      folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="20 s" output_step="5 ms")"));
  const auto before = std::signal(SIGHUP, SIG_IGN);  // which a program that is started inherits
  const ProgramRun run = runVehicle(
      {"simulate", folder.file("v.xml", smallVehicle()), scenario, "--form", "mbs", "--method", "rk4"}, hangUp);
  std::signal(SIGHUP, before);
  EXPECT_EQ(run.status, 0) << run.err;
}

}  // namespace
}  // namespace vehicle::test
