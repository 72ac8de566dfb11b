#include "libvehicle/definition/parameter.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/support/vehicles.h"

namespace vehicle {
namespace {

Scenario trackWithMembers() {
  Scenario scenario;
  scenario.run.speed = 20.0;
  scenario.track.emplace();
  scenario.track->harmonics.resize(2);
  scenario.track->harmonics[1].name = "wave";
  scenario.track->dips.resize(1);
  scenario.track->dips[0].name = "hollow";
  return scenario;
}

// Written through its address, a number is read back from there, and nothing else has changed: two addresses bound to
// the same number, or one to a wrong one, would show.
template <class Owner>
void expectEachToBeANumberOfItsOwn(const Owner& owner) {
  const std::vector<ParameterOf<Owner>> all = parametersOf(owner);
  std::set<std::string> addresses;
  for (const ParameterOf<Owner>& each : all) {
    SCOPED_TRACE(each.address);
    EXPECT_TRUE(addresses.insert(each.address).second);
    Owner changed = owner;
    constexpr double kNew = 123.456;
    each.setIn(changed, kNew);
    for (const ParameterOf<Owner>& other : all) {
      EXPECT_EQ(other.valueIn(changed), &other == &each ? std::optional<double>(kNew) : other.valueIn(owner))
          << other.address;
    }
  }
}

TEST(Parameters, OfAVehicleEachReadAndWriteANumberOfTheirOwn) {
  Vehicle vehicle = test::contactVehicle();
  vehicle.groups.emplace_back().name = "front";
  vehicle.points.emplace_back().name = "floor";
  expectEachToBeANumberOfItsOwn(vehicle);
}

TEST(Parameters, OfAScenarioEachReadAndWriteANumberOfTheirOwn) { expectEachToBeANumberOfItsOwn(trackWithMembers()); }

/// Whether check() says of an attribute that a value breaks a rule.
bool isRefused(const ProblemList& problems, std::string_view attribute, const std::string& rule) {
  return std::any_of(problems.begin(), problems.end(), [&](const Problem& each) {
    return each.message.starts_with(std::string(attribute) + "=\"") && each.remedy == rule;
  });
}

// A row is enough: what it says of the range is judged of every part that has the attribute.
template <class Owner>
void expectEachToBeJudgedAsItsRowSays(const Owner& owner) {
  for (const ParameterOf<Owner>& each : parametersOf(owner)) {
    SCOPED_TRACE(each.address);
    Owner changed = owner;
    each.setIn(changed, std::nan(""));
    EXPECT_TRUE(isRefused(check(changed), each.row->name, "must be finite")) << check(changed).text();
    each.setIn(changed, -1.0);
    const bool is_positive = each.row->sign == Sign::kPositive;
    // These have to be above 0 where the body pitches and where wheels roll, as they do here.
    const bool is_stricter = each.template is<&Body::pitch_inertia>() || each.template is<&Run::speed>();
    EXPECT_EQ(isRefused(check(changed), each.row->name, "must be > 0"), is_positive || is_stricter);
    EXPECT_EQ(isRefused(check(changed), each.row->name, "must be >= 0"),
              each.row->sign == Sign::kNotNegative && !is_stricter);
  }
}

TEST(Parameters, AreJudgedByCheckAsTheirRowsSay) {
  Vehicle vehicle = test::contactVehicle();
  std::erase_if(vehicle.bodies, [](const Body& each) { return !moves(each, Motion::kPitch); });
  vehicle.groups.emplace_back().name = "front";
  vehicle.points.emplace_back().name = "floor";
  expectEachToBeJudgedAsItsRowSays(vehicle);
  Scenario scenario = trackWithMembers();
  scenario.track->bumps.emplace_back().name = "bump";
  scenario.track->ramps.emplace_back().name = "ramp";
  expectEachToBeJudgedAsItsRowSays(scenario);
  scenario.rig.emplace().inputs.emplace_back().sines.emplace_back().name = "shake";
  expectEachToBeJudgedAsItsRowSays(scenario);
}

TEST(Parameters, AreAddressedAsPartAndAttribute) {
  const Vehicle vehicle = test::paperVehicle();
  const std::vector<VehicleParameter> all = parametersOf(vehicle);
  const VehicleParameter* mass = findParameter(all, "rear_bogie.mass");
  ASSERT_NE(mass, nullptr);
  EXPECT_EQ(mass->valueIn(vehicle), 9e3);
  EXPECT_EQ(mass->dimension, Dimension::kMass);
  Vehicle changed = vehicle;
  mass->setIn(changed, 8e3);
  EXPECT_EQ(changed.bodies[2].mass, 8e3);
  EXPECT_EQ(findParameter(all, "primary.stiffness_z")->valueIn(vehicle), 3040e3);
  EXPECT_EQ(findParameter(all, "wheelset_1.load")->valueIn(vehicle), std::nullopt);
  EXPECT_EQ(findParameter(all, "carbody.roll_inertia"), nullptr);
}

TEST(Parameters, OfATrackAreThoseOfItsNamedMembers) {
  const Scenario scenario = trackWithMembers();
  const std::vector<ScenarioParameter> all = parametersOf(scenario);
  EXPECT_EQ(findParameter(all, "speed")->valueIn(scenario), 20.0);
  EXPECT_EQ(findParameter(all, "scenario.gravity")->valueIn(scenario), 9.81);
  Scenario changed = scenario;
  findParameter(all, "scenario.wave.amplitude")->setIn(changed, 0.01);
  EXPECT_EQ(changed.track->harmonics[1].amplitude, 0.01);
  EXPECT_NE(findParameter(all, "scenario.hollow.depth"), nullptr);
  EXPECT_EQ(findParameter(all, "scenario..amplitude"), nullptr);
  EXPECT_EQ(findParameter(parametersOf(Scenario{}), "scenario.fade_in"), nullptr);
}

}  // namespace
}  // namespace vehicle
