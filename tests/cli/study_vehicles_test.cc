// Studies of every kind of vehicle, the ways they take, and the vehicle files that they write.
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "libvehicle/definition/parameter.h"
#include "libvehicle/storage/csv.h"
#include "libvehicle/xml/reader.h"
#include "tests/cli/studies.h"
#include "tests/support/tolerance.h"

namespace vehicle::test {
namespace {

using Json = nlohmann::json;

double valueOf(const Json& told, const std::string& design, const std::string& quantity) {
  for (const Json& row : told["tables"]["comparison"]["rows"]) {
    if (row["design"] == design && row["quantity"] == quantity) return row["value"].get<double>();
  }
  ADD_FAILURE() << design << " has no " << quantity << " in " << told["tables"]["comparison"].dump(1);
  return NAN;
}

double parameterOf(const std::string& file, const std::string& address) {
  const Vehicle vehicle = readVehicle(file).orThrow();
  const std::vector<VehicleParameter> all = parametersOf(vehicle);
  const VehicleParameter* found = findParameter(all, address);
  return found == nullptr ? NAN : found->valueIn(vehicle).value_or(NAN);
}

// The shipped study takes the closed form of the frequency domain; here the vehicle file that it writes runs through
// the exact propagator from its periodic state, and the r.m.s. is that of the samples of one period.
TEST(StudyOfTheCoach, ItsNumbersAreThoseOfARunOfTheVehicleItWrites) {
  const TestFolder folder;
  const std::string study = model("studies/secondary-suspensions.xml");
  const ProgramRun run = runVehicle({"study", study, "--output", folder.path("study.sqlite"), "--write-best",
                                     folder.path("best"), "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json told = Json::parse(run.out);
  const std::string first = folder.path("best/carbody-az-rms-1.xml"), second = folder.path("best/carbody-az-rms-2.xml");
  EXPECT_EQ(run.err, "written: " + first + "\nwritten: " + second + "\n");
  EXPECT_EQ(runVehicle({"check", first, second}).out, first + ": ok\n" + second + ": ok\n");
  EXPECT_EQ(readVehicle(second).orThrow().name, "manchester-coach-carbody-az-rms-2");
  // "soft" sags beyond the limit of 250 mm, "stiff" comes after "base".
  EXPECT_EQ(parameterOf(second, "secondary.stiffness_z"), 1300e3);
  EXPECT_EQ(parameterOf(second, "secondary.damping_z"), 60e3);
  struct Speed {
    const char* text;
    std::size_t samples;  // of 5 ms in the 50 m of the longest wave, of which the others are whole parts
  };
  for (const Speed& speed : {Speed{"80 km/h", 450}, Speed{"120 km/h", 300}, Speed{"160 km/h", 225}}) {
    const ProgramRun simulated = runVehicle({"simulate", second, model("scenarios/four-waves.xml"), "--speed",
                                             speed.text, "--output", folder.path("run.csv"), "--quiet"});
    ASSERT_EQ(simulated.status, 0) << simulated.err;
    const std::vector<double> az = readCsv(folder.path("run.csv")).orThrow().column("carbody.az");
    double sum = 0.0;
    for (std::size_t i = 0; i < speed.samples; ++i) sum += az[i] * az[i];
    // Sums over whole periods of sines are exact; rounding grows over 30 s of steps.
    EXPECT_WITHIN(valueOf(told, "stiff", std::string("carbody.az.rms @ ") + speed.text),
                  std::sqrt(sum / static_cast<double>(speed.samples)), 1e-10);
  }
  // Half of 32 t of carbody on an element that stands once a side: from the file, not from the study.
  const double half = parameterOf(second, "carbody.mass") / 2.0 * 9.81;
  EXPECT_WITHIN(valueOf(told, "stiff", "static.secondary_front.deflection"), half / 1300e3, 1e-12);
}

TEST(StudyModels, EveryShippedStudyIsInOrder) {
  std::size_t studies = 0;
  for (const auto& each : std::filesystem::directory_iterator(model("studies"))) {
    const ProgramRun run = runVehicle({"check", each.path().string()});
    EXPECT_EQ(run.out, each.path().string() + ": ok\n");
    EXPECT_EQ(run.status, 0);
    ++studies;
  }
  EXPECT_GE(studies, 5u);
}

/// A study of two designs of a shipped vehicle, one with a carbody 10 % heavier.
ProgramRun runOf(const TestFolder& folder, const std::string& vehicle, const std::string& evaluation) {
  std::string text = R"(<study name="heavier" format="1" EVALUATION>
  <vehicle file="VEHICLE"/>
  <scenario file="SCENARIO"/>
  <vary parameter="carbody.mass" kind="relative" values="110 %"/>
  <vary parameter="speed" values="20 m/s, 108 km/h"/>
  <metric name="carbody.az.rms"/>
</study>
)";
  text = with(with(text, "EVALUATION", evaluation), "VEHICLE", model(vehicle));
  const std::string study = folder.file("study.xml", with(text, "SCENARIO", model("scenarios/four-waves.xml")));
  const std::string database = folder.path("study.sqlite");
  std::filesystem::remove(database);
  return runVehicle({"study", study, "--output", database, "--format", "json"});
}

// Bogies that pitch, wheelsets with mass on contact springs: no lane of the ensemble holds them.
TEST(StudyOf, AVehicleThatIsNotFlatTakesAnotherWayAndSaysWhy) {
  const TestFolder folder;
  struct Case {
    const char* vehicle;
    const char* steady;  // how the remark of a steady state begins
    const char* run;     // and that of runs
    const char* why;
  };
  const std::vector<Case> cases = {
      {"vehicles/al-oraiqat-2017.xml", "steady state in closed form, flat form, ", "runs by rk4 ", "designs at once"},
      {"vehicles/manchester-coach.xml", "steady state in closed form, matrix form, design by design: ", "runs by exact",
       "front_bogie\">: has a pitch motion"},
      {"vehicles/manchester-coach-contact.xml", "steady state in closed form, matrix form, design by design: ",
       "runs by exact", "front_bogie\">: has a pitch motion"},
      {"vehicles/manchester-coach-hertz.xml", "steady state in closed form, matrix form, design by design: ",
       "runs by exact", "front_bogie\">: has a pitch motion"},
  };
  for (const Case& each : cases) {
    SCOPED_TRACE(each.vehicle);
    const ProgramRun steady = runOf(folder, each.vehicle, "evaluation=\"steady_state\"");
    const ProgramRun run = runOf(folder, each.vehicle, "settle=\"5 s\"");
    ASSERT_EQ(run.status, 0) << run.err;
    const Json told = Json::parse(run.out);
    const std::string remark = told["remarks"][0];
    EXPECT_EQ(remark.rfind(each.run, 0), 0u) << remark;
    EXPECT_TRUE(has(remark, each.why)) << remark;
    EXPECT_GT(valueOf(told, "#0", "carbody.az.rms @ 108 km/h"), 0.0);
    ASSERT_EQ(steady.status, 0) << steady.err;
    const std::string steady_remark = Json::parse(steady.out)["remarks"][0];
    EXPECT_EQ(steady_remark.rfind(each.steady, 0), 0u) << steady_remark;
    EXPECT_TRUE(has(steady_remark, each.why)) << steady_remark;
  }
}

const char* const kMixedUnits = R"(<study name="units" format="1" evaluation="steady_state">
  <vehicle file="v.xml"/>
  <scenario file="s.xml"/>
  <vary parameter="speed" values="20 m/s, 108 km/h"/>
  <design name="tons"><set parameter="spring.stiffness_z" value="0.1 tf/mm"/>
    <set parameter="spring.damping_z" value="0.02 kN*s/mm"/></design>
  <design name="newtons"><set parameter="spring.stiffness_z" value="980.665 N/mm"/>
    <set parameter="spring.damping_z" value="20000 kg/s"/></design>
  <metric name="carbody.az.rms"/>
  <limit metric="carbody.az.rms" below="30 cm/s^2"/>
</study>
)";

TEST(StudyOf, MixedUnitsAreTheSameNumbers) {
  const TestFolder folder;
  const ProgramRun run = runVehicle({"study", smallStudyIn(folder, kMixedUnits), "--output",
                                     folder.path("study.sqlite"), "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json told = Json::parse(run.out);
  for (const char* speed : {"72 km/h", "108 km/h"}) {
    const std::string metric = std::string("carbody.az.rms @ ") + speed;
    EXPECT_EQ(valueOf(told, "tons", metric), valueOf(told, "newtons", metric));
  }
  // 0.1 tf/mm = 980.665 kN/m; rounding.
  EXPECT_WITHIN(valueOf(told, "tons", "carbody.az.rms @ 108 km/h"), rmsOfSmall(980665.0, 20e3, 30.0), 1e-13);
}

// Two wagons of the small vehicle; the second one gets a softer spring.
constexpr const char* kTrain = R"(<train name="pair" format="1">
  <vehicle file="v.xml" name="wagon" count="2" spacing="12.5 m"/>
  <coupling stiffness_z="0 N/m" damping_z="0 N*s/m" end_x="5 m"/>
</train>
)";
constexpr const char* kTrainStudy = R"(<study name="pairs" format="1" evaluation="steady_state">
  <vehicle file="t.xml"/>
  <scenario file="s.xml"/>
  <design name="soft"><set parameter="wagon_2.spring.stiffness_z" value="0.5 MN/m"/></design>
  <design name="coupled"><set parameter="coupling.stiffness_z" value="100 kN/m"/></design>
  <metric name="wagon_1.carbody.az.rms"/>
  <metric name="wagon_2.carbody.az.rms"/>
</study>
)";

TEST(StudyOf, ATrainVariesTheNumbersOfOneOfItsVehicles) {
  const TestFolder folder;
  folder.file("t.xml", kTrain);
  const ProgramRun run = runVehicle({"study", smallStudyIn(folder, kTrainStudy), "--output",
                                     folder.path("study.sqlite"), "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json told = Json::parse(run.out);
  EXPECT_TRUE(has(told["remarks"][0], "design by design: the ensemble's lanes hold one vehicle, this is a train"))
      << told["remarks"];
  // Uncoupled wagons are two of the small vehicle; rounding of a larger system of equations.
  EXPECT_WITHIN(valueOf(told, "soft", "wagon_1.carbody.az.rms"), rmsOfSmall(1e6, 20e3, 20.0), 1e-12);
  EXPECT_WITHIN(valueOf(told, "soft", "wagon_2.carbody.az.rms"), rmsOfSmall(5e5, 20e3, 20.0), 1e-12);
  // Half a wave apart they move against each other and the coupling works with twice their motion: m z'' on 2 k_c more.
  EXPECT_GT(std::abs(valueOf(told, "coupled", "wagon_1.carbody.az.rms") - rmsOfSmall(1e6, 20e3, 20.0)), 1e-3);
}

TEST(StudyOf, ATrainWritesItsDesignsAsTrainFilesWithTheirVehicles) {
  const TestFolder folder;
  folder.file("t.xml", kTrain);
  const ProgramRun run = runVehicle({"study", smallStudyIn(folder, kTrainStudy), "--output",
                                     folder.path("study.sqlite"), "--write-best", folder.path("best")});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string soft = folder.path("best/soft.xml"), coupled = folder.path("best/coupled.xml");
  EXPECT_EQ(run.err, "written: " + folder.path("best/soft-wagon_1.xml") + "\nwritten: " +
                         folder.path("best/soft-wagon_2.xml") + "\nwritten: " + soft + "\nwritten: " +
                         folder.path("best/coupled-wagon_1.xml") + "\nwritten: " + coupled + "\n");
  EXPECT_EQ(runVehicle({"check", soft, coupled}).out, soft + ": ok\n" + coupled + ": ok\n");
  EXPECT_EQ(parameterOf(soft, "wagon_1.spring.stiffness_z"), 1e6);
  EXPECT_EQ(parameterOf(soft, "wagon_2.spring.stiffness_z"), 5e5);
  EXPECT_EQ(parameterOf(soft, "coupling.stiffness_z"), 0.0);
  EXPECT_EQ(parameterOf(coupled, "wagon_2.spring.stiffness_z"), 1e6);
  EXPECT_EQ(parameterOf(coupled, "coupling.stiffness_z"), 1e5);
  EXPECT_EQ(readTrain(soft).orThrow().name, "pair-soft");
  EXPECT_EQ(readTrain(coupled).orThrow().vehicles.size(), 1u);
}

TEST(StudyOf, NothingIsWrittenWhereNoDesignKeepsTheLimitsAndThatIsSaid) {
  const TestFolder folder;
  const ProgramRun run = runVehicle({"study", smallStudyIn(folder, with(smallStudy(), "150 mm", "1 mm")), "--output",
                                     folder.path("study.sqlite"), "--write-best", folder.path("best")});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "note: --write-best: nothing is written: no design keeps the limits\n");
  EXPECT_TRUE(has(run.out, "\nwithin limits  0\n")) << run.out;
}

}  // namespace
}  // namespace vehicle::test
