// Studies and suites that users wrote: what they have to find, or to refuse.
#include <complex>
#include <cstdint>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/quarter_coach.h"
#include "tests/cli/studies.h"
#include "tests/support/source_tree.h"

namespace vehicle::test {
namespace {

using Json = nlohmann::json;

/// A folder with copies of all case files: studies name their files beside them.
class Cases {
 public:
  Cases() {
    for (const auto& each : std::filesystem::directory_iterator(sourcePath("tests/cli/cases"))) {
      folder_.file(each.path().filename().string(), textOf(each.path().string()));
    }
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }
  std::string file(const std::string& name, const std::string& text) const { return folder_.file(name, text); }

  /// The json of a study that is run to its end.
  [[nodiscard]] Json results(const std::string& study, std::vector<std::string> words = {}) const {
    words.insert(words.begin(), {"study", path(study), "--output", path(study + ".sqlite"), "--format", "json", "-q"});
    const ProgramRun run = runVehicle(words);
    EXPECT_EQ(run.status, 0) << run.err;
    return Json::parse(run.out);
  }

 private:
  TestFolder folder_;
};

std::vector<Json> rowsOf(const Json& report, const std::string& table, const std::string& key,
                         const std::string& value) {
  std::vector<Json> rows;
  for (const Json& row : report["tables"][table]["rows"]) {
    if (row[key] == value) rows.push_back(row);
  }
  return rows;
}

// The only excitation is 195 Hz, which samples 5 ms apart show at 5 Hz. Allowed: 1e-3 of the r.m.s. of the motion; of the
// r.m.s. itself 1e-9 by solves and 39 * 50 whole waves.
TEST(StudyCases, AWaveFasterThanTheSamplesIsInNoBandBelowIt) {
  const Cases cases;
  const double right = frameAcceleration(QuarterCoach(), 0.01e-3, 2.0 * std::numbers::pi * 195.0) / std::sqrt(2.0);
  for (const std::string study : {"alias-run.xml", "alias-steady.xml"}) {
    const Json report = cases.results(study);
    const std::vector<Json> rms = rowsOf(report, "comparison", "quantity", "frame.az.rms");
    const std::vector<Json> band = rowsOf(report, "comparison", "quantity", "frame.az.band(4..8 Hz)");
    ASSERT_EQ(rms.size(), 2u) << study;
    ASSERT_EQ(band.size(), 2u) << study;
    for (std::size_t i = 0; i < rms.size(); ++i) {
      EXPECT_NEAR(rms[i]["value"].get<double>(), right, 1e-9 * right) << study;
      EXPECT_NEAR(band[i]["value"].get<double>(), 0.0, 1e-3 * right) << study;
    }
  }
}

// Bounce of a carbody on two bogies that bounce with it: M s^2 z = 2 (c s + k)(b - z) and, for one bogie,
// m s^2 b = (c s + k)(z - b) - 2 (cp s + kp) b. Newton's method on the determinant, from the undamped root.
std::complex<double> bounceRoot(double k) {
  using C = std::complex<double>;
  const auto determinant = [&](C s) {
    const C second = 100e3 * s + k, first = 2.0 * (30e3 * s + 3e6);
    return (57e3 * s * s + 2.0 * second) * (9e3 * s * s + second + first) - 2.0 * second * second;
  };
  C s(0.0, std::sqrt(2.0 * k / 57e3));
  for (int i = 0; i < 60; ++i) {
    const C h = 1e-6 * std::abs(s);
    s -= determinant(s) * 2.0 * h / (determinant(s + h) - determinant(s - h));
  }
  return s;
}

TEST(StudyCases, AModeThatStopsOscillatingTakesNothingElseWithIt) {
  const Cases cases;
  const Json report = cases.results("mode-name-sweep.xml");
  EXPECT_EQ(report["facts"]["failed"]["value"], 0);
  EXPECT_EQ(report["facts"]["with values missing"]["value"], 5);
  std::map<std::int64_t, std::map<std::string, Json>> designs;
  for (const Json& row : report["tables"]["comparison"]["rows"]) {
    designs[row["id"].get<std::int64_t>()][row["quantity"].get<std::string>()] = row["value"];
  }
  std::size_t without = 0;
  for (auto& [id, values] : designs) {
    EXPECT_TRUE(values["carbody.az.rms"].is_number()) << id;
    const double right = std::abs(bounceRoot(values["secondary.stiffness_z"].get<double>())) / (2.0 * std::numbers::pi);
    // Newton's method by differences converges to their rounding.
    EXPECT_NEAR(values["mode.carbody bounce.frequency"].get<double>(), right, 1e-7 * right) << id;
    without += values["mode.carbody pitch.frequency"].is_null() ? 1u : 0u;
  }
  EXPECT_EQ(designs.size(), 31u);
  EXPECT_EQ(without, 5u);
}

TEST(StudyCases, DesignsThatLiftAreCountedAndNamedInTheirColumn) {
  const Cases cases;
  cases.file("hollow.xml", with(textOf(cases.path("lift.xml")), "<dip ", "<dip name=\"hollow\" "));
  cases.file("lifts.xml", R"(<study name="lifts" format="1">
  <vehicle file="quarter-hertz.xml"/> <scenario file="hollow.xml"/>
  <design name="long"><set parameter="scenario.hollow.length" value="30 m"/></design>
  <metric name="axle.load.min"/>
</study>
)");
  // Thirty metres of the same depth: v pi d / L is a tenth, of 245 kN that the load falls 25 kN are left.
  const Json report = cases.results("lifts.xml", {"--export", cases.path("lifts.csv")});
  EXPECT_EQ(report["facts"]["with warnings"]["value"], 1);
  const std::vector<Json> rows = rowsOf(report, "warnings", "code", "WHEEL_LOAD");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0]["value"], 1);
  EXPECT_TRUE(has(rows[0]["message"], "1 of 2 designs, the first is base")) << rows[0];
  const std::vector<std::string> lines = linesOf(textOf(cases.path("lifts.csv")));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_TRUE(has(lines[0], ",warnings,")) << lines[0];
  EXPECT_TRUE(has(lines[1], ",WHEEL_LOAD,")) << lines[1];
  EXPECT_FALSE(has(lines[2], "WHEEL_LOAD")) << lines[2];
  EXPECT_EQ(runVehicle({"study", "show", cases.path("lifts.xml.sqlite"), "--strict"}).status, 4);
  // From below zero to above it the load has grown.
  const std::vector<Json> loads = rowsOf(report, "comparison", "quantity", "axle.load.min");
  ASSERT_EQ(loads.size(), 2u);
  const double base = loads[0]["value"].get<double>(), other = loads[1]["value"].get<double>();
  EXPECT_NEAR(loads[1]["change"].get<double>(), 100.0 * (other - base) / std::abs(base), 1e-10);
}

TEST(StudyCases, ASteadyStateOfAVehicleThatCannotStandHasNoValueAndSaysWhy) {
  const Cases cases;
  cases.file("tips.xml", R"(<study name="tips" format="1" evaluation="steady_state">
  <vehicle file="tips-over.xml"/> <scenario file="two-waves.xml"/>
  <vary parameter="leaf.stiffness_z" values="600 kN/m"/>
  <metric name="wagon.az.rms"/>
</study>
)");
  const Json report = cases.results("tips.xml");
  // The base cannot: 2 k a^2 is 50 kN m beside 245 of m g h. With 600 kN/m it is 300.
  const std::vector<Json> values = rowsOf(report, "comparison", "quantity", "wagon.az.rms");
  ASSERT_EQ(values.size(), 2u);
  EXPECT_TRUE(values[0]["value"].is_null());
  EXPECT_GT(values[1]["value"].get<double>(), 0.0);
  const std::vector<Json> missing = rowsOf(report, "missing values", "metric", "wagon.az.rms");
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing[0]["why"], "no steady state: the vehicle cannot stand");
  const std::vector<Json> warnings = rowsOf(report, "warnings", "code", "CANNOT_STAND");
  ASSERT_EQ(warnings.size(), 2u);  // of the file, and of the designs
  EXPECT_EQ(warnings[0]["line"], 6);
  EXPECT_EQ(warnings[1]["value"], 1);
}

// The static load depends on the mass alone: the indices of the others are a zero of either sign.
TEST(StudyCases, IndicesThatAreNothingAreNoNegativeZero) {
  const Cases cases;
  cases.file("loads.xml", R"(<study name="loads" format="1" evaluation="steady_state">
  <vehicle file="short-pitch-loco.xml"/> <scenario file="two-waves.xml"/>
  <vary parameter="secondary.stiffness_z" from="1 MN/m" to="3 MN/m"/>
  <vary parameter="secondary.damping_z" from="1 kN*s/m" to="100 kN*s/m"/>
  <vary parameter="carbody.mass" from="50 t" to="60 t"/>
  <plan kind="saltelli" size="64" second_order="yes" seed="1"/>
  <metric name="static.w1.load"/>
</study>
)");
  const ProgramRun run = runVehicle({"study", cases.path("loads.xml"), "--output", cases.path("loads.sqlite"), "-q"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(has(run.out, "0.000")) << run.out;
  EXPECT_FALSE(has(run.out, "-0.000")) << run.out;
}

// What the command refuses `check` refuses, in the same lines.
TEST(StudyCases, CheckRefusesWhatTheCommandRefuses) {
  const Cases cases;
  const struct {
    std::string file;
    std::vector<std::string> command;
    std::vector<std::string> says;
  } table[] = {
      {"list.xml", {"study", "list.xml", "--output", "list.sqlite"}, {"list.csv:1: error: the fields are separated"}},
      {"huge-grid.xml",
       {"study", "huge-grid.xml", "--output", "grid.sqlite"},
       {"huge-grid.xml:5: error: <study><plan>: makes more than 1000000000 designs"}},
      {"suite-unknown-form.xml",
       {"validate", "suite-unknown-form.xml"},
       {"suite-unknown-form.xml:1: error: <suite><form>: form \"falt\" is unknown; did you mean \"flat\"?",
        "suite-unknown-form.xml:1: error: <suite><method>: method \"rk5\" is unknown; did you mean \"rk4\"?"}},
  };
  for (const auto& each : table) {
    std::vector<std::string> command = each.command;
    for (std::string& word : command) {
      if (has(word, ".xml") || has(word, ".sqlite")) word = cases.path(word);
    }
    const ProgramRun checked = runVehicle({"check", cases.path(each.file)}), run = runVehicle(command);
    EXPECT_EQ(checked.status, 1);
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(checked.out, run.err);
    const std::vector<std::string> lines = linesOf(run.err);
    ASSERT_EQ(lines.size(), each.says.size()) << run.err;
    for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_TRUE(has(lines[i], each.says[i])) << lines[i];
    EXPECT_FALSE(std::filesystem::exists(cases.path("list.sqlite")));
    EXPECT_FALSE(std::filesystem::exists(cases.path("grid.sqlite")));
  }
}

TEST(StudyCases, ASuiteInWhichNothingRunsSaysSoOnce) {
  const Cases cases;
  const ProgramRun run = runVehicle({"validate", cases.path("suite-nothing-runs.xml"), "-q"});
  EXPECT_EQ(run.status, 4);
  EXPECT_EQ(linesOf(run.err).size(), 1u) << run.err;
  EXPECT_TRUE(run.err.starts_with(cases.path("suite-nothing-runs.xml") + ":1: warning: s: nothing is judged: "))
      << run.err;
  EXPECT_TRUE(run.err.ends_with("[NOTHING_JUDGED]\n")) << run.err;
}

}  // namespace
}  // namespace vehicle::test
