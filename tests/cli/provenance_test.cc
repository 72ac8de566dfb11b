// A result keeps the files that it was made from as they were read, whatever happens to them while the program works.
#include <csignal>
#include <string>

#include <gtest/gtest.h>

#include "libvehicle/storage/hdf5.h"
#include "libvehicle/storage/study_database.h"
#include "tests/cli/studies.h"

namespace vehicle::test {
namespace {

TEST(Provenance, OfARunIsWhatWasReadThoughTheFilesAreEditedMeanwhile) {
  const TestFolder folder;
  const std::string run = R"(speed="20 m/s" duration="4000 s" output_step="10 ms")";
  folder.file("wagon.xml", smallVehicle());
  const std::string train = folder.file(
      "t.xml", R"(<train name="t" format="1"><vehicle file="wagon.xml" count="2" spacing="20 m"/></train>)");
  const std::string scenario = folder.file("s.xml", smallScenario(run));
  const auto edit_and_end = [&](pid_t process) {
    folder.file("wagon.xml", "edited");
    folder.file("t.xml", "edited");
    folder.file("s.xml", "edited");
    kill(process, SIGINT);
  };
  const ProgramRun ended =
      runVehicle({"simulate", train, scenario, "--form", "mbs", "--method", "rk4", "--output", folder.path("run.h5")},
                 showsProgress, edit_and_end);
  ASSERT_EQ(ended.status, 130) << ended.err;
  const RunRecord record = readHdf5(folder.path("run.h5")).orThrow();
  ASSERT_EQ(record.inputs.size(), 3u);
  EXPECT_EQ(record.inputs[0].name, train);
  EXPECT_TRUE(has(record.inputs[0].text, "<train name=\"t\""));
  EXPECT_EQ(record.inputs[1].text, smallScenario(run));
  EXPECT_EQ(record.inputs[2].text, smallVehicle());
}

TEST(Provenance, OfAStudyIsWhatWasReadThoughTheFilesAreEditedMeanwhile) {
  const TestFolder folder;
  const std::string varied = R"(<vary parameter="suspension.x" from="-1 mm" to="1 mm"/>
  <plan kind="sobol" size="100000000"/>)";
  const std::string text = with(smallStudy(), "<vary parameter=\"speed\" values=\"20 m/s, 108 km/h\"/>", varied);
  const std::string study = smallStudyIn(folder, text);
  const std::string database = folder.path("study.sqlite");
  const auto edit_and_end = [&](pid_t process) {
    for (const char* name : {"study.xml", "v.xml", "s.xml"}) folder.file(name, "edited");
    kill(process, SIGINT);
  };
  const ProgramRun ended = runVehicle({"study", study, "--output", database}, hasComputedSince(database), edit_and_end);
  ASSERT_EQ(ended.status, 130) << ended.err;
  const StudyRecord record = StudyDatabase::read(database).record();
  ASSERT_EQ(record.inputs.size(), 3u);
  EXPECT_EQ(record.inputs[0].text, text);
  EXPECT_EQ(record.inputs[1].text, smallVehicle());
  // And the database is shown from what it keeps, edited or gone as the files may be.
  const ProgramRun shown = runVehicle({"study", "show", database});
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_TRUE(has(shown.out, "carbody.az.rms")) << shown.out;
}

}  // namespace
}  // namespace vehicle::test
