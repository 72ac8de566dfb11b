// No warning is given for the shipped models, except where it is true: each exception stands here with its number.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "libvehicle/project/model.h"
#include "libvehicle/simulate/simulate.h"
#include "tests/cli/studies.h"

namespace vehicle::test {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

std::vector<std::string> filesOf(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& each : fs::directory_iterator(model(folder))) files.push_back(each.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> vehicles() {
  std::vector<std::string> files = filesOf("vehicles");
  for (const std::string& each : filesOf("trains")) files.push_back(each);
  return files;
}

std::string nameOf(const std::string& path) { return fs::path(path).stem().string(); }

/// Half the carbody's weight on the secondary of one bogie, both cars alike but for mass and spring [m].
const std::map<std::string, double>& restDeflections() {
  static const std::map<std::string, double> deflections = {{"pioneer-m", 42.4e3 * 9.81 / 2.0 / 0.4e6},
                                                            {"pioneer-r", 44e3 * 9.81 / 2.0 / 0.35e6}};
  return deflections;
}

/// Of these the two secondaries come down by more than half a metre, and that is all.
template <class Warned>
void expectRestDeflections(const std::string& vehicle, const Warned& found) {
  const auto exception = restDeflections().find(vehicle);
  if (exception == restDeflections().end()) {
    EXPECT_TRUE(found.empty()) << vehicle;
    return;
  }
  EXPECT_GT(exception->second, 0.5);
  ASSERT_EQ(found.size(), 2u) << vehicle;
  for (const auto& [code, value] : found) {
    EXPECT_EQ(code, "REST_DEFLECTION");
    EXPECT_NEAR(value, exception->second, 1e-9) << vehicle;
  }
}

TEST(ShippedVehicles, AreWarnedOfWhereTheirSpringsComeDownTooFarAndNowhereElse) {
  for (const std::string& file : vehicles()) {
    for (const std::string command : {"check", "info", "modes"}) {
      const ProgramRun run = runVehicle({command, file, "--format", "json", "-q", "--strict"});
      const bool is_exception = restDeflections().contains(nameOf(file));
      EXPECT_EQ(run.status, is_exception ? 4 : 0) << command << ' ' << file << run.err;
      std::vector<std::pair<std::string, double>> found;
      const Json report = Json::parse(run.out);
      for (const Json& row : report["tables"]["warnings"]["rows"]) {
        found.emplace_back(row["code"], row["value"].get<double>());
      }
      expectRestDeflections(nameOf(file), found);
    }
  }
}

constexpr double kSpeed = 20.0;                          // [m/s] of the shipped scenarios
constexpr double kCoachLoad = 11123.0;                   // [kg] that a wheelset of the coach carries, itself included
constexpr double kWheelset = 1813.0;                     // [kg]
constexpr double kContact = 2.35e9;                      // [N/m], linear about the static load
constexpr double kWave = 2.0 * std::numbers::pi / 25.0;  // [1/m] of the paper's first harmonic

/// Height of the paper's rail at a place [m].
double paperRail(double x) { return 5e-3 * std::sin(kWave * x) + 2e-3 * std::sin(3.0 * kWave * x); }

/// A wheel whose rail drops or rises with a velocity from one instant on swings about it: v sqrt(k m) of its load.
double loadOfSlope(double slope) { return kSpeed * slope * std::sqrt(kContact * kWheelset); }

struct Lifting {
  double lowest;     // load by hand [N]
  double allowance;  // of what the hand leaves out [N]
};

/// Pairs in which the coach's wheelsets with mass, on their contacts, would leave the rail.
const std::map<std::string, Lifting>& liftings() {
  const double load = kCoachLoad * 9.81;
  // Where its wheelsets stand as the first one passes 0, the rail is not at 0: their contacts are pulled by all of it.
  double lowest_rail = 0.0;
  for (const double behind : {0.0, 2.56, 19.0, 21.56}) lowest_rail = std::min(lowest_rail, paperRail(-behind));
  static const std::map<std::string, Lifting> pairs = {
      // Its end is a corner: the slope jumps from pi d / L to 0, after the wheel has swung since its begin; two full
      // swings may add or cancel. What counts is that one alone is more than the load.
      {"half-sine-dip", {load - loadOfSlope(std::numbers::pi * 5e-3 / 3.0), 120e3}},
      {"paper-20mps-extended", {load + kContact * lowest_rail, 1e5}},
      // The rail rises from flat; half a swing later the wheel pulls. Its primary carries 1 % of it.
      {"paper-20mps", {load - loadOfSlope(kWave * (5e-3 + 3.0 * 2e-3)), 3e3}},
      {"rig", {load - kContact * 6.2e-3 * std::sin(1.57), 1e5}},
  };
  return pairs;
}

TEST(ShippedPairs, AreWarnedOfWhereAWheelWouldPullAndNowhereElse) {
  int ran = 0;
  std::set<std::string> lifted;
  FileSource disk;
  for (const std::string& vehicle : vehicles()) {
    for (const std::string& scenario : filesOf("scenarios")) {
      if (nameOf(scenario) == "rig" && has(vehicle, "/trains/")) continue;  // it drives wheelsets of one vehicle
      const std::string pair = nameOf(vehicle) + " over " + nameOf(scenario);
      SCOPED_TRACE(pair);
      const Model model = readModel(vehicle, scenario, disk);
      const RunResult result = simulate(model.vehicle, model.scenario);
      ++ran;
      std::vector<std::pair<std::string, double>> others;
      double lowest = 0.0;
      for (const Warning& each : result.warnings) {
        if (each.code == WarningCode::kWheelLoad) {
          lowest = std::min(lowest, *each.value);
        } else {
          others.emplace_back(wordOf(each.code), *each.value);
        }
      }
      expectRestDeflections(nameOf(vehicle), others);
      const bool has_contact = has(vehicle, "-contact.") || has(vehicle, "-hertz.");
      const auto exception = liftings().find(nameOf(scenario));
      if (!has_contact || exception == liftings().end()) {
        EXPECT_EQ(lowest, 0.0);
        continue;
      }
      lifted.insert(pair);
      EXPECT_LT(exception->second.lowest, 0.0) << "the exception is true";
      EXPECT_LT(lowest, 0.0);
      EXPECT_NEAR(lowest, exception->second.lowest, exception->second.allowance);
    }
  }
  EXPECT_EQ(ran, 16 * 9 - 3);
  EXPECT_EQ(lifted.size(), 8u);
}

// Studies as they are, but for the number of points of the two large plans and generations of the search, of which these
// are the first.
TEST(ShippedStudies, AreNotWarnedOf) {
  const std::map<std::string, std::vector<std::string>> smaller = {
      {"million-designs", {"size=\"1000000\"", "size=\"4096\""}},
      {"influences", {"size=\"4096\"", "size=\"64\""}},
      {"comfort-against-deflection", {"generations=\"100\"", "generations=\"10\""}},
  };
  const TestFolder folder;
  for (const std::string& file : filesOf("studies")) {
    std::string text = textOf(file);
    const auto change = smaller.find(nameOf(file));
    if (change != smaller.end()) text = with(text, change->second[0], change->second[1]);
    for (std::size_t at = 0; (at = text.find("file=\"../", at)) != std::string::npos;) {
      text.replace(at, 9, "file=\"" + model(""));
    }
    const std::string study = folder.file(nameOf(file) + ".xml", text);
    const ProgramRun run =
        runVehicle({"study", study, "--output", study + ".sqlite", "--strict", "--quiet", "--format", "json"});
    EXPECT_EQ(run.status, 0) << file << run.err;
    EXPECT_EQ(run.err, "") << file;
    EXPECT_TRUE(Json::parse(run.out)["tables"]["warnings"]["rows"].empty()) << file;
  }
}

// A suite warns of its pairs and speeds as the default run of each finds them, whatever else it compares: two forms do.
TEST(ShippedSuites, AreNotWarnedOf) {
  for (const std::string& file : filesOf("suites")) {
    const ProgramRun run = runVehicle({"validate", file, "--form", "flat", "--form", "matrix", "--method", "exact",
                                       "--strict", "--quiet", "--format", "json"});
    EXPECT_EQ(run.status, 0) << file << run.err;
    EXPECT_EQ(run.err, "") << file;
    EXPECT_TRUE(Json::parse(run.out)["tables"]["warnings"]["rows"].empty()) << file;
  }
}

}  // namespace
}  // namespace vehicle::test
