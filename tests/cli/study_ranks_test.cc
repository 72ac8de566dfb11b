// The program under mpirun: the ranks may outnumber the cores here.
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "tests/cli/studies.h"

namespace vehicle::test {
namespace {

/// @returns exit status of mpirun
int runRanks(const std::string& arguments, const std::string& err) {
  const std::string command =
      "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_btl_vader_single_copy_mechanism=none "
      "'" VEHICLE_MPIRUN "' --oversubscribe -n 2 '" +
      programPath() + "' " + arguments + " >/dev/null 2>'" + err + "'";
  const int state = std::system(command.c_str());
  return WIFEXITED(state) ? WEXITSTATUS(state) : -1;
}

TEST(StudyRanks, TwoRanksExportTheBytesOfASerialRun) {
  const TestFolder folder;
  const std::string varied = R"(<vary parameter="carbody.mass" from="40 t" to="70 t"/>
  <vary parameter="secondary.stiffness_z" from="300 kN/m" to="4 MN/m"/>
  <vary parameter="speed" values="20 m/s, 100 km/h"/>
  <plan kind="saltelli" size="256" second_order="yes"/>)";
  // Some designs lack a mode's frequency: their gaps travel between the ranks.
  const std::string study = folder.file(
      "study.xml",
      paperStudy(varied, R"(<metric name="carbody.az.rms"/><metric name="mode.carbody pitch.frequency"/>)"));
  const std::string serial = folder.path("serial.csv"), shared = folder.path("shared.csv"), err = folder.path("err");
  const std::string database = folder.path("serial.sqlite");
  ASSERT_EQ(runVehicle({"study", study, "--output", database, "--export", serial, "--jobs", "1"}).status, 0);
  const std::string to = " --output '" + folder.path("shared.sqlite") + "' --export '" + shared + "'";
  ASSERT_EQ(runRanks("study '" + study + "'" + to, err), 0) << textOf(err);
  EXPECT_EQ(linesOf(textOf(serial)).size(), 2u + 256u * 6u);
  EXPECT_TRUE(has(textOf(serial), ",\"mode.carbody pitch.frequency: the mode is overdamped")) << textOf(serial);
  EXPECT_TRUE(textOf(shared) == textOf(serial));
}

TEST(StudyRanks, WhatIsWrongIsToldOnceAndEndsAllRanks) {
  const TestFolder folder;
  const std::string study = smallStudyIn(folder, with(smallStudy(), "spring.stiffness_z", "sprung.stiffness_z"));
  const std::string err = folder.path("err");
  EXPECT_EQ(runRanks("study '" + study + "' --output '" + folder.path("to.sqlite") + "'", err), 1);
  const std::string told = textOf(err);
  const std::size_t first = told.find("did you mean \"spring.stiffness_z\"?");
  EXPECT_NE(first, std::string::npos) << told;
  EXPECT_EQ(told.find("did you mean", first + 1), std::string::npos) << told;
  // The leader finds the file in the way, the other rank has nothing to say.
  const std::string there = folder.file("there.sqlite", "mine");
  EXPECT_EQ(runRanks("study '" + smallStudyIn(folder) + "' --output '" + there + "'", err), 2) << textOf(err);
  EXPECT_TRUE(has(textOf(err), there + " exists already; go on with it by --resume")) << textOf(err);
}

}  // namespace
}  // namespace vehicle::test
