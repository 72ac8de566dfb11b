#include "libvehicle/study/evaluate/flat_designs.h"

#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "tests/study/inputs.h"

namespace vehicle {
namespace {

using namespace test;

Vehicle loadedVehicle() {
  Vehicle made = withHeights(asymmetricVehicle(), 0.4);
  for (Wheelset& each : made.wheelsets) each.mass = 1800.0;
  made.wheelsets[1].load = 90e3;
  return made;
}

std::vector<Vary> springsAndMasses(const Vehicle& vehicle) {
  std::vector<Vary> varies;
  for (const Element& each : vehicle.elements) {
    varies.push_back(range(each.name + ".stiffness_z", "1 MN/m", "4 MN/m"));
    varies.push_back(range(each.name + ".damping_z", "10 kN*s/m", "90 kN*s/m"));
  }
  for (const Body& each : vehicle.bodies) varies.push_back(range(each.name + ".mass", "5 t", "60 t"));
  varies.push_back(range("carbody.pitch_inertia", "50 t*m^2", "900 t*m^2"));
  return varies;
}

bool sameBits(const EnsembleDesign& a, const EnsembleDesign& b) {
  static_assert(std::is_trivially_copyable_v<EnsembleDesign>);
  return std::memcmp(&a, &b, sizeof a) == 0;  // doubles only: no padding
}

// The short way writes values into a topology; it has to be the long way in every bit, on any vehicle.
TEST(FlatDesigns, TheShortWayGivesTheBitsOfTheLongWay) {
  std::mt19937_64 random(20'171'122);
  for (const Vehicle& vehicle : {paperVehicle(), asymmetricVehicle(), heightsVehicle(), loadedVehicle()}) {
    std::vector<Vary> varies = springsAndMasses(vehicle);
    if (vehicle.wheelsets[0].mass) {
      varies.push_back(range("wheelset_2.mass", "1 t", "3 t"));
      varies.push_back(range("wheelset_1.load", "50 kN", "120 kN"));
    }
    const StudyInputs inputs = inputsOf(studyOf(varies, {"carbody.az.rms"}), vehicle, {paperScenario(History::kOnset)});
    FlatDesigns fast(inputs);
    FlatDesigns slow(inputs);
    slow.useReferencePath();
    ASSERT_TRUE(fast.geometryIsFixed());
    for (int i = 0; i < 300; ++i) {
      std::vector<double> values;
      for (const Factor& each : inputs.bound.factors) {
        values.push_back(each.from + (each.to - each.from) * std::uniform_real_distribution<>()(random));
      }
      ASSERT_FALSE(fast.set(values));
      ASSERT_FALSE(slow.set(values));
      EXPECT_TRUE(sameBits(fast.design(9.81), slow.design(9.81))) << vehicle.name << " design " << i;
    }
  }
}

TEST(FlatDesigns, APlaceThatVariesTakesTheLongWay) {
  const StudyInputs inputs = inputsOf(studyOf({range("wheelset_1.x, primary_1.x", "7 m", "9 m")}, {"carbody.az.rms"}),
                                      asymmetricVehicle(), {paperScenario(History::kOnset)});
  FlatDesigns designs(inputs);
  EXPECT_FALSE(designs.geometryIsFixed());
  ASSERT_FALSE(designs.set(std::vector{8.25, 8.25}));
  EXPECT_EQ(designs.topology().wheelsets[1].x, 8.25);
}

TEST(FlatDesigns, AValueThatCannotBeIsToldByTheChecksOfTheVehicle) {
  const StudyInputs inputs = inputsOf(studyOf({range("carbody.mass", "40 t", "60 t"),
                                               range("primary.damping_z", "10 kN*s/m", "40 kN*s/m")},
                                              {"carbody.az.rms"}),
                                      paperVehicle(), {paperScenario(History::kOnset)});
  FlatDesigns designs(inputs);
  EXPECT_EQ(designs.set(std::vector{-5.0, 30e3}), "<vehicle><body name=\"carbody\">: mass=\"-5 kg\"; must be > 0");
  EXPECT_TRUE(designs.set(std::vector{57e3, -1.0}));
  EXPECT_TRUE(designs.set(std::vector{57e3, std::nan("")}));
  EXPECT_TRUE(designs.set(std::vector{INFINITY, 30e3}));
  EXPECT_FALSE(designs.set(std::vector{57e3, 0.0}));
  EXPECT_EQ(designs.design(9.81).vehicle.bp[0], 0.0);
}

}  // namespace
}  // namespace vehicle
