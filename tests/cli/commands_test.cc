#include <chrono>
#include <cmath>
#include <csignal>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "libvehicle/storage/csv.h"
#include "libvehicle/storage/hdf5.h"
#include "tests/cli/program.h"
#include "tests/support/source_tree.h"

namespace vehicle::test {
namespace {

using Json = nlohmann::json;

const std::string kRun = R"(speed="20 m/s" duration="1 s" output_step="5 ms")";

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(CheckCommand, SaysOkForEveryFileThatIsRight) {
  const TestFolder folder;
  const std::string vehicle = folder.file("v.xml", smallVehicle());
  const std::string scenario = folder.file("s.xml", smallScenario(kRun));
  const ProgramRun run = runVehicle({"check", vehicle, scenario});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, vehicle + ": ok\n" + scenario + ": ok\n");
  EXPECT_EQ(run.err, "");
}

TEST(CheckCommand, PrintsTheProblemsOfAllFilesAndEndsWithOne) {
  const TestFolder folder;
  std::string wrong = smallVehicle();
  wrong.replace(wrong.find("10 t"), 4, "10 m");
  const std::string vehicle = folder.file("v.xml", wrong);
  const std::string scenario = folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="1 kg")"));
  const ProgramRun run = runVehicle({"check", vehicle, scenario, folder.path("none.xml")});
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(has(run.out, vehicle + ":3: error: ")) << run.out;
  EXPECT_TRUE(has(run.out, scenario + ":2: error: ")) << run.out;
  EXPECT_TRUE(has(run.out, folder.path("none.xml") + ": error: ")) << run.out;
}

TEST(CheckCommand, HoldsAScenarioAgainstTheVehicleBesideIt) {
  const TestFolder folder;
  const std::string vehicle = folder.file("v.xml", smallVehicle());
  std::string text = smallScenario(kRun);
  text.insert(text.find("</scenario>"), R"(<initial_state><body name="carboody" z="1 mm"/></initial_state>)");
  const std::string scenario = folder.file("s.xml", text);
  EXPECT_EQ(runVehicle({"check", scenario}).status, 0);
  const ProgramRun run = runVehicle({"check", vehicle, scenario});
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(has(run.out, "carboody")) << run.out;
}

TEST(CheckCommand, JsonHoldsPlaceMessageAndRemedy) {
  const TestFolder folder;
  std::string wrong = smallVehicle();
  wrong.replace(wrong.find("10 t"), 4, "10 m");
  const ProgramRun run = runVehicle({"check", folder.file("v.xml", wrong), "--format", "json"});
  EXPECT_EQ(run.status, 1);
  const Json row = Json::parse(run.out)["tables"]["files"]["rows"][0];
  EXPECT_EQ(row["line"], 3);
  EXPECT_EQ(row["verdict"], "error");
  EXPECT_NE(row["remedy"], "");
}

TEST(InfoCommand, TellsLoadsRestAndWhyAFormDoesNotFit) {
  const TestFolder folder;
  const ProgramRun run = runVehicle({"info", folder.file("v.xml", smallVehicle()), "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json tables = Json::parse(run.out)["tables"];
  // 10 t on 1 MN/m under 9.81 m/s^2: 98.1 kN, 98.1 mm; one division and two products of doubles round to 1e-16 of that.
  EXPECT_NEAR(tables["wheelsets"]["rows"][0]["static load"].get<double>(), 98.1e3, 1e-9);
  EXPECT_NEAR(tables["bodies"]["rows"][0]["rest z"].get<double>(), -98.1e-3, 1e-15);
  EXPECT_EQ(tables["forms"]["rows"][0], Json({{"form", "flat"}, {"fits", false}}));
  EXPECT_EQ(tables["forms"]["rows"][1], Json({{"form", "matrix"}, {"fits", true}}));
  EXPECT_FALSE(tables["why a form does not fit"]["rows"].empty());
}

TEST(InfoCommand, ListsWhatThePlanarFormsDoNotUse) {
  const TestFolder folder;
  std::string text = smallVehicle();
  text.replace(text.find("mass=\"10 t\""), 11, "mass=\"10 t\" roll_inertia=\"56.8 t*m^2\"");
  const ProgramRun run = runVehicle({"info", folder.file("v.xml", text)});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(has(run.out, "not used by the planar forms: roll_inertia of carbody\n")) << run.out;
}

TEST(ModesCommand, OfOneMassAreThoseOfTheTextbook) {
  const TestFolder folder;
  const ProgramRun run = runVehicle({"modes", folder.file("v.xml", smallVehicle()), "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json mode = Json::parse(run.out)["tables"]["modes"]["rows"][0];
  // w = sqrt(k/m) = 10 1/s, zeta = c / (2 sqrt(k m)) = 0.1; eigenvalue solver's rounding.
  EXPECT_NEAR(mode["frequency"].get<double>(), 10.0 / (2.0 * 3.14159265358979323846), 1e-12);
  EXPECT_NEAR(mode["damping ratio"].get<double>(), 0.1, 1e-12);
  EXPECT_NEAR(mode["undamped frequency"].get<double>(), 10.0 / (2.0 * 3.14159265358979323846), 1e-12);
  EXPECT_NEAR(mode["damped frequency"].get<double>(), 10.0 * std::sqrt(0.99) / (2.0 * 3.14159265358979323846), 1e-12);
  EXPECT_EQ(Json::parse(run.out)["tables"]["shapes"]["rows"][0]["coordinate"], "carbody.z");
}

// The published case: 2.7 MN/m under a body whose pitch is overdamped at 0.6 MN/m.
TEST(ModesCommand, AnAperiodicModeHasNoDampedFrequencyButThatOfItsMassesAndStiffnesses) {
  const TestFolder folder;
  std::string text = textOf(sourcePath("tests/cli/cases/short-pitch-loco.xml"));
  text.replace(text.find("2.7 MN/m"), 8, "0.6 MN/m");
  const ProgramRun run = runVehicle({"modes", folder.file("v.xml", text), "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  std::vector<double> rates;
  const Json answer = Json::parse(run.out);
  for (const Json& mode : answer["tables"]["modes"]["rows"]) {
    if (!mode["name"].get<std::string>().starts_with("carbody pitch, aperiodic")) continue;
    rates.push_back(mode["frequency"]);
    EXPECT_TRUE(mode["damped frequency"].is_null());
    // (J w^2 - K)(m w^2 - ks - 2 kp) = K ks with K = 2 a^2 ks, the lower of its two roots.
    const double ks = 0.6e6, kp = 3e6, J = 70e3, m = 9e3, K = 2.0 * 3.7 * 3.7 * ks;
    const double b = m * K + J * (ks + 2.0 * kp), c = 2.0 * K * kp;
    const double w = std::sqrt((b - std::sqrt(b * b - 4.0 * J * m * c)) / (2.0 * J * m));
    EXPECT_NEAR(mode["undamped frequency"].get<double>(), w / (2.0 * 3.14159265358979323846), 1e-12);
  }
  ASSERT_EQ(rates.size(), 2u);
  EXPECT_NEAR(rates[0], 1.170, 5e-4);
  EXPECT_NEAR(rates[1], 6.542, 5e-4);
}

TEST(ModesCommand, ShowsShapesAsAMatrixWithCoordinatesAsRows) {
  const ProgramRun run = runVehicle({"modes", model("vehicles/manchester-coach.xml")});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::size_t at = run.out.find("\nshapes: ");
  ASSERT_NE(at, std::string::npos) << run.out;
  const std::string shapes = run.out.substr(at + 1);
  // A symmetric coach: both bogies alike in bounce, opposite in pitch; the bogies' own pitch is theirs alone.
  for (const char* row : {"\n  coordinate               mode 1  ", "\n  carbody.z [m]            1 (0) ",
                          "\n  rear_bogie.pitch [rad]   0      "}) {
    EXPECT_TRUE(has(shapes, row)) << row << shapes;
  }
  std::size_t lines = 0;
  for (const char letter : shapes) lines += letter == '\n' ? 1 : 0;
  EXPECT_EQ(lines, 8u) << shapes;  // title, modes, six coordinates
  EXPECT_FALSE(has(shapes, "-0)")) << shapes;
}

TEST(SimulateCommand, PrintsASummaryThatIsAlikeInAllFormats) {
  const TestFolder folder;
  const std::string vehicle = folder.file("v.xml", smallVehicle());
  const std::string scenario = folder.file("s.xml", smallScenario(kRun));
  const ProgramRun table = runVehicle({"simulate", vehicle, scenario});
  const ProgramRun csv = runVehicle({"simulate", vehicle, scenario, "--format", "csv"});
  const ProgramRun json = runVehicle({"simulate", vehicle, scenario, "--format", "json"});
  ASSERT_EQ(table.status, 0) << table.err;
  EXPECT_EQ(table.err, "");
  EXPECT_TRUE(has(table.out, "carbody.z"));
  EXPECT_EQ(csv.out.rfind("column,unit,min,max,peak,at [s],mean,rms\ncarbody.z,m,", 0), 0u) << csv.out;
  const Json row = Json::parse(json.out)["tables"]["columns"]["rows"][0];
  EXPECT_EQ(row["column"], "carbody.z");
  const std::string line = csv.out.substr(csv.out.find("carbody.z,m,") + 12);
  EXPECT_EQ(std::stod(line), row["min"].get<double>());
  EXPECT_EQ(Json::parse(json.out)["facts"]["method"]["value"], "exact");
}

TEST(SimulateCommand, WritesHistoriesThatReadBackAlike) {
  const TestFolder folder;
  const std::string vehicle = folder.file("v.xml", smallVehicle());
  const std::string scenario = folder.file("s.xml", smallScenario(kRun));
  const ProgramRun run = runVehicle({"simulate", vehicle, scenario, "--method", "rk4", "--step", "2 ms", "--speed",
                                     "36 km/h", "--output", folder.path("run.csv"), "--output", folder.path("run.h5")});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "written: " + folder.path("run.csv") + "\nwritten: " + folder.path("run.h5") + "\n");
  const TimeHistory csv = readCsv(folder.path("run.csv")).orThrow();
  const RunRecord hdf5 = readHdf5(folder.path("run.h5")).orThrow();
  ASSERT_EQ(csv.samples(), 201u);
  EXPECT_EQ(csv.columns(), hdf5.history.columns());
  for (std::size_t j = 0; j < csv.columns().size(); ++j) EXPECT_EQ(csv.column(j), hdf5.history.column(j));
  ASSERT_EQ(hdf5.inputs.size(), 2u);
  EXPECT_EQ(hdf5.inputs[0].text, smallVehicle());
  const auto attribute = [&](const std::string& name) {
    for (const auto& [key, value] : hdf5.attributes) {
      if (key == name) return value;
    }
    return std::string();
  };
  EXPECT_EQ(attribute("speed"), "10 m/s");
  EXPECT_EQ(attribute("step"), "0.002 s");
  EXPECT_EQ(attribute("method"), "rk4");
}

TEST(SimulateCommand, QuietLeavesStderrEmpty) {
  const TestFolder folder;
  const ProgramRun run =
      runVehicle({"simulate", folder.file("v.xml", smallVehicle()), folder.file("s.xml", smallScenario(kRun)),
                  "--quiet", "--output", folder.path("run.csv")});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out, "");
}

TEST(SimulateCommand, TheProblemsOfBothFilesStandOnStderrWithStatusOne) {
  const TestFolder folder;
  const ProgramRun run = runVehicle({"simulate", folder.file("v.xml", "<vehicle"), folder.path("none.xml")});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(has(run.err, folder.path("v.xml"))) << run.err;
  EXPECT_TRUE(has(run.err, folder.path("none.xml"))) << run.err;
}

TEST(SimulateCommand, AFormThatDoesNotFitIsAWrongInputWithTheElementNamed) {
  const TestFolder folder;
  const ProgramRun run = runVehicle(
      {"simulate", folder.file("v.xml", smallVehicle()), folder.file("s.xml", smallScenario(kRun)), "--form", "flat"});
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(has(run.err, folder.path("v.xml"))) << run.err;
}

TEST(SimulateCommand, AnOutputThatCannotBeWrittenIsToldBeforeTheRunWithStatusThree) {
  const TestFolder folder;
  const ProgramRun run =
      runVehicle({"simulate", folder.file("v.xml", smallVehicle()), folder.file("s.xml", smallScenario(kRun)),
                  "--output", folder.path("no-such-folder/run.csv")});
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(has(run.err, "no-such-folder/run.csv: cannot be written")) << run.err;
}

TEST(SimulateCommand, CtrlCEndsALongRunAndKeepsWhatIsDone) {
  const TestFolder folder;
  const std::string scenario =
      folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="40000 s" output_step="10 ms")"));
  const ProgramRun run = runVehicle({"simulate", folder.file("v.xml", smallVehicle()), scenario, "--form", "mbs",
                                     "--method", "rk4", "--output", folder.path("run.csv")},
                                    showsProgress, [](pid_t process) { kill(process, SIGINT); });
  EXPECT_EQ(run.status, 130) << run.err;
  EXPECT_TRUE(has(run.err, "vehicle: interrupted at t = ")) << run.err;
  const TimeHistory kept = readCsv(folder.path("run.csv")).orThrow();
  EXPECT_GT(kept.samples(), 10u);
  EXPECT_LT(kept.samples(), 4000000u);
}

TEST(SimulateCommand, AStiffRunOfDopri5NamesWhatWouldDoBetter) {
  const TestFolder folder;
  std::string stiff = smallVehicle();
  const std::string axle = R"(<wheelset name="wheelset" x="0 m")";
  stiff.insert(stiff.find(axle) + axle.size(),
               R"( mass="1.5 t" contact_stiffness="2.4 GN/m" contact_damping="50 MN*s/m")");
  const std::vector<std::string> run = {"simulate", folder.file("v.xml", stiff),
                                        folder.file("s.xml", smallScenario(kRun)), "--method", "dopri5"};
  const ProgramRun answer = runVehicle(run);
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.err.rfind("note: dopri5 took ", 0), 0u) << answer.err;
  EXPECT_TRUE(answer.err.ends_with("take --method exact, which needs no steps\n")) << answer.err;
  std::vector<std::string> exact = run;
  exact.back() = "exact";
  EXPECT_EQ(runVehicle(exact).err, "");
}

TEST(ValidateCommand, ASmallVehicleIsInsideAndEveryPairStandsInTheJson) {
  const TestFolder folder;
  const ProgramRun run = runVehicle({"validate", folder.file("v.xml", smallVehicle()),
                                     folder.file("s.xml", smallScenario(kRun)), "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json report = Json::parse(run.out);
  EXPECT_EQ(report["facts"]["inside"]["value"], true);
  EXPECT_GT(report["tables"]["pairs"]["rows"].size(), 30u);
  for (const Json& pair : report["tables"]["pairs"]["rows"]) {
    EXPECT_EQ(pair["verdict"], "inside");
    EXPECT_NE(pair["expected because of"], "");
  }
}

TEST(ValidateCommand, PairsOfTheTableNameTheirReason) {
  const TestFolder folder;
  const ProgramRun run =
      runVehicle({"validate", folder.file("v.xml", smallVehicle()), folder.file("s.xml", smallScenario(kRun)), "--form",
                  "matrix", "--form", "mbs-linear", "--method", "rk4", "--step", "5 ms", "--details"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(has(run.out, "rounding: same equations, same rk4 steps")) << run.out;
  EXPECT_TRUE(has(run.out, "integration: rk4 at 5 ms, by Richardson")) << run.out;
}

TEST(ValidateCommand, ASuiteGetsOneLineACase) {
  const TestFolder folder;
  static_cast<void>(folder.file("v.xml", smallVehicle()));
  static_cast<void>(folder.file("s.xml", smallScenario(kRun)));
  const std::string suite = folder.file("suite.xml", R"(<suite name="two-speeds" format="1">
  <vehicle file="v.xml"/> <scenario file="s.xml"/>
  <speed from="10 m/s" to="30 m/s" count="2"/> <form name="matrix"/> <form name="mbs"/> <method name="dopri5"/>
</suite>
)");
  const ProgramRun run = runVehicle({"validate", suite, "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json cases = Json::parse(run.out)["tables"]["cases"]["rows"];
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(cases[1]["speed"], 30.0);
  EXPECT_EQ(cases[1]["outside"], 0);
}

TEST(ValidateCommand, CtrlCEndsItAndSaysHowFarItCame) {
  const TestFolder folder;
  const std::string scenario =
      folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="3000 s" output_step="10 ms")"));
  const ProgramRun run = runVehicle({"validate", folder.file("v.xml", smallVehicle()), scenario, "--form", "mbs"},
                                    showsProgress, [](pid_t process) { kill(process, SIGINT); });
  EXPECT_EQ(run.status, 130) << run.err;
  EXPECT_EQ(run.err, "vehicle: interrupted; 0 of 1 cases are finished\n");
}

TEST(SchemaCommand, PrintsXsdAndMarkdown) {
  EXPECT_EQ(runVehicle({"schema"}).out, runVehicle({"schema", "--xsd"}).out);
  EXPECT_TRUE(has(runVehicle({"schema", "--xsd"}).out, "<xs:schema"));
  const ProgramRun markdown = runVehicle({"schema", "--markdown"});
  EXPECT_EQ(markdown.status, 0);
  EXPECT_TRUE(has(markdown.out, "stiffness_z"));
}

}  // namespace
}  // namespace vehicle::test
