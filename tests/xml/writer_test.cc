#include "libvehicle/xml/writer.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "libvehicle/xml/reader.h"
#include "tests/support/vehicles.h"
#include "tests/xml/files.h"

namespace vehicle {
namespace {

// As in the paper, written as a person writes it, with a group and with quantities that are only kept.
constexpr const char* kTwoGroups = R"(<vehicle name="al-oraiqat-2017" format="1">
  <title>Locomotive section &amp; more</title>
  <source>Al-Oraiqat, Sec. II</source>

  <element name="primary"   stiffness_z="3040 kN/m" damping_z="30 kN*s/m"/>
  <element name="secondary" stiffness_z="2660 kN/m" damping_z="100 kN*s/m" stiffness_y="0.20 MN/m"/>

  <body name="carbody" mass="57 t" pitch_inertia="70 t*m^2" motion="z pitch" yaw_inertia="1 t*m^2" roll_inertia="5e1 kg*m^2"/>

  <group name="front" x="3.725 m">
    <body name="front_bogie" mass="9 t" motion="z"/>
    <wheelset name="wheelset_1" x="1.5 m"/>
    <wheelset name="wheelset_2" x="-1.5 m"/>
    <suspension name="secondary_front" element="secondary" upper="carbody"     lower="front_bogie"/>
    <suspension name="primary_1"       element="primary"   upper="front_bogie" lower="wheelset_1"  x="1.5 m"/>
    <suspension name="primary_2"       element="primary"   upper="front_bogie" lower="wheelset_2"  x="-1.5 m"/>
  </group>

  <group name="rear" x="-3.725 m">
    <body name="rear_bogie" mass="9 t" motion="z"/>
    <wheelset name="wheelset_3" x="1.5 m"/>
    <suspension name="secondary_rear" element="secondary" upper="carbody"    lower="rear_bogie"/>
    <suspension name="primary_3"      element="primary"   upper="rear_bogie" lower="wheelset_3" x="1.5 m"/>
  </group>

  <wheelset name="wheelset_4" x="-5.225 m"/>

  <suspension name="primary_4" element="primary" upper="rear_bogie" lower="wheelset_4" x="-5.225 m" y="1 m" sides="2"/>

  <point name="floor_mid" body="carbody"/>
</vehicle>
)";

constexpr const char* kTrack = R"(<scenario name="all-members" format="1" gravity="9.80665 m/s^2">
  <title>Every member of a track</title>
  <run speed="20 m/s" distance="200 m" output_step="10 ms"/>
  <track history="onset" fade_in="50 m">
    <harmonic wavelength="25 m"           amplitude="5 mm"                rail="left"/>
    <harmonic wavelength="25 m" order="3" amplitude="2 mm" phase="1 mrad"/>
    <harmonic name="long" wavelength="100 m" amplitude="1 mm"/>
    <dip shape="half_sine"        depth="8 mm" length="2 m" start="20 m"/>
    <dip shape="one_minus_cosine" depth="8 mm" length="2 m" start="40 m" rail="right"/>
    <bump name="joint" shape="one_minus_cosine" height="10 mm" length="3 m" start="50 m" rail="left"/>
    <ramp rise="10 mm" length="5 m" start="60 m" rail="right"/>
  </track>
  <initial_state from="on_rail">
    <body name="carbody" z="-3.1 mm" pitch="1.2 mrad" z_rate="22 mm/s" pitch_rate="-8.5 mrad/s"/>
  </initial_state>
</scenario>
)";

constexpr const char* kRig = R"(<scenario name="rig" format="1">
  <run duration="10 s"/>
  <rig>
    <input wheelset="wheelset_1">
      <sine amplitude="6.2 mm" angular_frequency="5.03 rad/s"  phase="0.3 rad"/>
      <sine amplitude="1 mm"   angular_frequency="15.09 rad/s"/>
    </input>
    <input wheelset="wheelset_2">
      <sine name="shake" amplitude="-1 mm" frequency="0.8 Hz"/>
    </input>
  </rig>
</scenario>
)";

constexpr const char* kSuite = R"(<suite name="paper-speeds" format="1">
  <vehicle file="../vehicles/al-oraiqat-2017.xml"/>
  <vehicle file="../vehicles/a &amp; b &#9;.xml"/>

  <scenario file="../scenarios/paper-20mps.xml"/>

  <speed from="20 km/h" to="150 km/h" count="14"/>
  <speed value="20 m/s"/>

  <form name="flat"/>
  <form name="mbs-linear"/>

  <method name="exact"/>
</suite>
)";

TEST(Writer, AFileInItsOwnFormComesBackLetterByLetter) {
  EXPECT_EQ(write(readVehicleText(kTwoGroups, "v.xml").orThrow()), kTwoGroups);
  EXPECT_EQ(write(readScenarioText(kTrack, "s.xml").orThrow()), kTrack);
  EXPECT_EQ(write(readScenarioText(kRig, "r.xml").orThrow()), kRig);
  EXPECT_EQ(write(readSuiteText(kSuite, "u.xml").orThrow()), kSuite);
}

TEST(Writer, GroupsAndReservedQuantitiesAreRead) {
  const Vehicle vehicle = readVehicleText(kTwoGroups, "v.xml").orThrow();
  ASSERT_EQ(vehicle.bodies.size(), 3u);
  EXPECT_EQ(vehicle.bodies[1].group, "front");
  EXPECT_EQ(vehicle.suspensions[1].group, "front");
  EXPECT_EQ(vehicle.wheelsets[3].group, "");
  EXPECT_EQ(vehicle.bodies[0].reserved,
            (std::vector<ReservedQuantity>{{"yaw_inertia", "1 t*m^2"}, {"roll_inertia", "5e1 kg*m^2"}}));
  EXPECT_EQ(vehicle.wheelsets[2].origin.file, "v.xml");
  EXPECT_EQ(vehicle.wheelsets[2].origin.line, 21);
}

TEST(Writer, OneHeightStandsForBothEnds) {
  test::Lines lines = test::kVehicleLines;
  lines[2] = R"(  <body name="frame" mass="9 t" z="0.9 m" motion="z"/>)";
  lines[3] = R"(  <wheelset name="axle" x="1 m" z="0.46 m"/>)";
  lines[4] = R"(  <suspension name="spring" element="primary" upper="frame" lower="axle" x="1 m" z="0.5 m"/>)";
  const Vehicle vehicle = readVehicleText(test::textOf(lines), "v.xml").orThrow();
  EXPECT_EQ(vehicle.suspensions[0].z_upper, 0.5);
  EXPECT_EQ(vehicle.suspensions[0].z_lower, 0.5);
  const std::string text = write(vehicle);
  EXPECT_NE(text.find(" z=\"0.5 m\""), std::string::npos) << text;
  EXPECT_EQ(text.find("z_upper"), std::string::npos) << text;
  EXPECT_EQ(readVehicleText(text, "v.xml").orThrow(), vehicle);
}

std::uint64_t bitsOf(double value) { return std::bit_cast<std::uint64_t>(value); }

// Random mantissas over 24 decades: the customary units ("mm", "kN/m") divide by powers of ten, and whatever is
// not exact in them must be written in SI with 17 digits.
TEST(Writer, EveryNumberComesBackToTheSameBits) {
  std::mt19937_64 random(20171);
  std::uniform_real_distribution<double> mantissa(1.0, 10.0);
  std::uniform_int_distribution<int> exponent(-12, 12);
  const auto draw = [&] { return mantissa(random) * std::pow(10.0, exponent(random)); };
  for (int i = 0; i < 300; ++i) {
    Vehicle vehicle = test::paperVehicle();
    for (Element& each : vehicle.elements) each.stiffness_z = draw(), each.damping_z = draw();
    for (Body& each : vehicle.bodies) each.mass = draw(), each.x = -draw(), each.z = draw();
    for (Wheelset& each : vehicle.wheelsets) each.mass = draw(), each.hertz_constant = draw(), each.load = draw();
    for (Suspension& each : vehicle.suspensions) each.z_upper = draw(), each.z_lower = draw(), each.preload = -draw();
    vehicle.bodies[0].pitch_inertia = draw();
    vehicle.bodies[0].x = -0.0;
    const auto outcome = readVehicleText(write(vehicle), "v.xml");
    ASSERT_EQ(outcome.problems.text(), "");
    ASSERT_EQ(*outcome.value, vehicle);
    EXPECT_EQ(bitsOf(outcome.value->bodies[0].x), bitsOf(-0.0));

    Scenario scenario = test::paperScenario(History::kExtended);
    scenario.gravity = draw();
    scenario.run.speed = draw();
    scenario.track->harmonics[0].phase = draw();
    scenario.track->harmonics[0].order = draw();
    scenario.initial_state.bodies.push_back({"carbody", draw(), -draw(), draw(), -draw(), {}});
    ASSERT_EQ(readScenarioText(write(scenario), "s.xml").orThrow(), scenario);
  }
}

TEST(Writer, RefusesNumbersThatAreNotFinite) {
  Vehicle vehicle = test::paperVehicle();
  vehicle.bodies[0].mass = std::numeric_limits<double>::quiet_NaN();
  try {
    (void)write(vehicle);
    FAIL() << "written";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "write: mass = nan, must be finite");
  }
}

TEST(Writer, RefusesAnOrderThatNoFileCanGive) {
  Vehicle vehicle = readVehicleText(kTwoGroups, "v.xml").orThrow();
  std::swap(vehicle.wheelsets[1], vehicle.wheelsets[3]);  // wheelset_2 of the front group after the rear one
  try {
    (void)write(vehicle);
    FAIL() << "written";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "write: the parts of <vehicle> are in an order that its groups cannot give");
  }
  vehicle.wheelsets[1].group = "middle";
  try {
    (void)write(vehicle);
    FAIL() << "written";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "write: a <wheelset> stands in group \"middle\", which does not exist");
  }
}

}  // namespace
}  // namespace vehicle
