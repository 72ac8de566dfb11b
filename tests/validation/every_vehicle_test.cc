#include <ostream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "libvehicle/validation/validation.h"
#include "tests/support/vehicles.h"

namespace vehicle {
namespace {

struct Named {
  std::string name;
  Vehicle vehicle;
  // Without it the test's name would show the bytes of the struct, other ones in every run.
  friend void PrintTo(const Named& named, std::ostream* out) { *out << named.name; }
};

Vehicle undampedPaperVehicle() {
  Vehicle vehicle = test::paperVehicle();
  for (Element& element : vehicle.elements) element.damping_z = 0.0;
  return vehicle;
}

Scenario harmonics(double duration) {
  Scenario scenario = test::paperScenario(History::kOnset);
  scenario.run.duration = duration;
  return scenario;
}

/// A round dip that all wheels pass, then one with corners.
Scenario dips(double duration) {
  Scenario scenario = harmonics(duration);
  scenario.track->harmonics.clear();
  Dip dip;
  dip.depth = 12e-3;
  dip.length = 6.0;
  dip.start = 4.0;
  scenario.track->dips = {dip, dip};
  scenario.track->dips[1].shape = DipShape::kHalfSine;
  scenario.track->dips[1].start = 30.0;
  return scenario;
}

class EveryVehicle : public ::testing::TestWithParam<Named> {};

// The ledger derives its sizes from each vehicle, track and speed: none of them may need a size of its own.
TEST_P(EveryVehicle, IsInsideOnHarmonicsSlowlyAndOnDipsFast) {
  for (const auto& [scenario, speed] : {std::pair(harmonics(1.2), 8.0), std::pair(dips(1.0), 45.0)}) {
    ValidationChoice choice;
    choice.run.speed = speed;
    choice.run.accuracy = 1e-8;  // the contact at 200 Hz costs simbody_rkm ten times the steps at 1e-10
    const ValidationReport report = validate(GetParam().vehicle, scenario, choice);
    EXPECT_TRUE(report.inside()) << speed << " m/s";
    EXPECT_GT(report.count(Verdict::kInside), 30u);
    for (const PairAgreement& pair : report.pairs) {
      EXPECT_EQ(pair.verdict, Verdict::kInside)
          << report.runs[pair.first].key.text() << " against " << report.runs[pair.second].key.text() << " at " << speed
          << " m/s in " << pair.columns[pair.worst].column.name << ": " << pair.columns[pair.worst].norms.max_difference
          << " against " << pair.columns[pair.worst].expected.value_or(0.0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Validate, EveryVehicle,
    ::testing::Values(Named{"Undamped", undampedPaperVehicle()}, Named{"Asymmetric", test::asymmetricVehicle()},
                      Named{"BogiePitch", test::bogiePitchVehicle()}, Named{"Contact", test::contactVehicle()},
                      Named{"Hertz", test::hertzVehicle()}, Named{"Heights", test::heightsVehicle()},
                      Named{"HeightsAboveTheCentre", test::heightsVehicle(-0.3)},
                      Named{"BogiePitchHeights", test::bogiePitchHeightsVehicle(0.2)}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace vehicle
