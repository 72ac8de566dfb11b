// What the flat form refuses, word for word, naming the element.
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/flat/flat_form.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

std::string unsupportedOf(const Vehicle& vehicle, FlatVariant variant = FlatVariant::kConsistent) {
  return flatUnsupported(topologyOf(vehicle), variant).text();
}

TEST(FlatUnsupported, AreNoneForCarbodiesOnTwoBogies) {
  EXPECT_EQ(unsupportedOf(paperVehicle()), "");
  EXPECT_EQ(unsupportedOf(asymmetricVehicle()), "");
  EXPECT_EQ(unsupportedOf(heightsVehicle()), "");
  for (const FlatVariant variant : {FlatVariant::kPrinted7, FlatVariant::kLiteral, FlatVariant::kLiteralMb}) {
    EXPECT_EQ(unsupportedOf(paperVehicle(), variant), "");
  }
}

// Its mass enters the load only.
TEST(FlatUnsupported, AreNoneForAWheelsetWithMassThatFollowsTheRail) {
  Vehicle vehicle = paperVehicle();
  for (Wheelset& each : vehicle.wheelsets) each.mass = 1800.0;
  EXPECT_EQ(unsupportedOf(vehicle), "");
}

TEST(FlatUnsupported, NamePitchingBogiesAndTheirLines) {
  Vehicle vehicle = bogiePitchVehicle();
  vehicle.bodies[1].origin.file = "coach.xml";
  vehicle.bodies[1].origin.line = 41;
  vehicle.bodies[2].origin.file = "coach.xml";
  vehicle.bodies[2].origin.line = 43;
  EXPECT_EQ(unsupportedOf(vehicle),
            "coach.xml:41: error: <vehicle><body name=\"front_bogie\">: has a pitch motion; the form flat computes "
            "the bounce of a bogie and no pitch; take the form matrix, which computes both\n"
            "coach.xml:43: error: <vehicle><body name=\"rear_bogie\">: has a pitch motion; the form flat computes "
            "the bounce of a bogie and no pitch; take the form matrix, which computes both\n");
}

TEST(FlatUnsupported, NameWheelsetsWithAMotionOfTheirOwn) {
  Vehicle vehicle = paperVehicle();
  vehicle.wheelsets[2].mass = 1800.0;
  vehicle.wheelsets[2].contact_stiffness = 2e9;
  EXPECT_EQ(unsupportedOf(vehicle),
            "error: <vehicle><wheelset name=\"wheelset_3\">: has mass and contact, and so a motion of its own; the "
            "form flat computes wheelsets that follow the rail; take the form matrix, or remove the contact\n");
}

TEST(FlatUnsupported, NameTheCarbodyThatDoesNotPitch) {
  Vehicle vehicle = paperVehicle();
  vehicle.bodies[0].motion = {Motion::kZ};
  EXPECT_EQ(unsupportedOf(vehicle),
            "error: <vehicle><body name=\"carbody\">: moves in z only; the form flat computes z and pitch of the "
            "carbody; take the form matrix, or write motion=\"z pitch\" with a pitch_inertia\n");
}

TEST(FlatUnsupported, NameTheCarbodyThatOnlyPitches) {
  Vehicle vehicle = paperVehicle();
  vehicle.bodies[0].motion = {Motion::kPitch};
  EXPECT_EQ(unsupportedOf(vehicle),
            "error: <vehicle><body name=\"carbody\">: moves in pitch only; the form flat computes z and pitch of the "
            "carbody; take the form matrix, or write motion=\"z pitch\" with a pitch_inertia\n");
}

TEST(FlatUnsupported, NameTheBogieThatOnlyPitches) {
  Vehicle vehicle = paperVehicle();
  vehicle.bodies[1].motion = {Motion::kPitch};
  vehicle.bodies[1].pitch_inertia = 9e3;
  EXPECT_EQ(unsupportedOf(vehicle),
            "error: <vehicle><body name=\"front_bogie\">: has a pitch motion; the form flat computes the bounce of a "
            "bogie and no pitch; take the form matrix, which computes both\n");
}

Vehicle withThirdBogie() {
  Vehicle vehicle = paperVehicle();
  vehicle.bodies.push_back(body("middle_bogie", 9e3, 0.0, std::nullopt, {Motion::kZ}));
  vehicle.wheelsets.push_back(wheelset("wheelset_5", 0.7));
  vehicle.wheelsets.push_back(wheelset("wheelset_6", -0.7));
  vehicle.suspensions.push_back(suspension("secondary_middle", "secondary", "carbody", "middle_bogie", 0.0));
  vehicle.suspensions.push_back(suspension("primary_5", "primary", "middle_bogie", "wheelset_5", 0.7));
  vehicle.suspensions.push_back(suspension("primary_6", "primary", "middle_bogie", "wheelset_6", -0.7));
  return vehicle;
}

TEST(FlatUnsupported, NameTheCarbodyOnThreeBogies) {
  EXPECT_EQ(unsupportedOf(withThirdBogie()),
            "error: <vehicle><body name=\"carbody\">: stands on 3 bogies (\"front_bogie\", \"rear_bogie\", "
            "\"middle_bogie\"); the form flat computes two; take the form matrix, which computes any vehicle\n");
}

TEST(FlatUnsupported, NameTheBogieWithOneAxle) {
  Vehicle vehicle = paperVehicle();
  vehicle.wheelsets.pop_back();
  vehicle.suspensions.pop_back();
  EXPECT_EQ(unsupportedOf(vehicle),
            "error: <vehicle><body name=\"rear_bogie\">: stands on wheelsets by 1 suspension (\"primary_3\"); the "
            "form flat computes two for each bogie; take the form matrix, which computes any vehicle\n");
}

TEST(FlatUnsupported, NameTheBogieWithThreeAxles) {
  Vehicle vehicle = paperVehicle();
  vehicle.wheelsets.push_back(wheelset("wheelset_5", 3.7));
  vehicle.suspensions.push_back(suspension("primary_5", "primary", "front_bogie", "wheelset_5", 3.7));
  EXPECT_EQ(unsupportedOf(vehicle),
            "error: <vehicle><body name=\"front_bogie\">: stands on wheelsets by 3 suspensions (\"primary_1\", "
            "\"primary_2\", \"primary_5\"); the form flat computes two for each bogie; take the form matrix, which "
            "computes any vehicle\n");
}

TEST(FlatUnsupported, NameTheBogieThatStandsTwiceOnAWheelset) {
  Vehicle vehicle = paperVehicle();
  named(vehicle.suspensions, "primary_2").lower = "wheelset_1";
  vehicle.wheelsets.erase(vehicle.wheelsets.begin() + 1);
  EXPECT_EQ(unsupportedOf(vehicle),
            "error: <vehicle><body name=\"front_bogie\">: stands on the wheelset \"wheelset_1\" twice; the form flat "
            "computes two wheelsets for each bogie; take the form matrix, which computes any vehicle\n");
}

TEST(FlatUnsupported, NameTheBogieUnderTwoSecondaries) {
  Vehicle vehicle = paperVehicle();
  vehicle.suspensions.push_back(suspension("secondary_extra", "secondary", "carbody", "front_bogie", 3.0));
  EXPECT_EQ(unsupportedOf(vehicle),
            "error: <vehicle><body name=\"front_bogie\">: carries bodies by 2 suspensions (\"secondary_front\", "
            "\"secondary_extra\"); the form flat computes one for each bogie; take the form matrix, which computes "
            "any vehicle\n");
}

TEST(FlatUnsupported, NameTheSuspensionFromCarbodyToWheelset) {
  Vehicle vehicle = paperVehicle();
  vehicle.suspensions.push_back(suspension("strut", "primary", "carbody", "wheelset_1", 5.225));
  EXPECT_EQ(unsupportedOf(vehicle),
            "error: <vehicle><suspension name=\"strut\">: joins the carbody \"carbody\" to a wheelset; the form flat "
            "computes carbodies that stand on bogies; take the form matrix, which computes any vehicle\n"
            "error: <vehicle><wheelset name=\"wheelset_1\">: carries 2 bodies (\"front_bogie\", \"carbody\"); the "
            "form flat computes wheelsets that carry one bogie each; take the form matrix, which computes any "
            "vehicle\n");
}

TEST(FlatUnsupported, NameTheWheelsetUnderTwoBogies) {
  Vehicle vehicle = paperVehicle();
  named(vehicle.suspensions, "primary_3").lower = "wheelset_2";
  vehicle.wheelsets.erase(vehicle.wheelsets.begin() + 2);
  EXPECT_EQ(unsupportedOf(vehicle),
            "error: <vehicle><wheelset name=\"wheelset_2\">: carries 2 bodies (\"front_bogie\", \"rear_bogie\"); the "
            "form flat computes wheelsets that carry one bogie each; take the form matrix, which computes any "
            "vehicle\n");
}

TEST(FlatUnsupported, NameTheSecondCarbodyAndBodiesOfAThirdFloor) {
  Vehicle vehicle = paperVehicle();
  vehicle.bodies.push_back(body("cab", 2e3, 6.0, std::nullopt, {Motion::kZ}));
  vehicle.suspensions.push_back(suspension("cab_mount", "primary", "cab", "front_bogie", 6.0));
  EXPECT_EQ(unsupportedOf(vehicle),
            "error: <vehicle><body name=\"cab\">: is a second carbody beside \"carbody\"; the form flat computes one "
            "carbody; take the form matrix, which computes any vehicle\n"
            "error: <vehicle><body name=\"front_bogie\">: carries bodies by 2 suspensions (\"secondary_front\", "
            "\"cab_mount\"); the form flat computes one for each bogie; take the form matrix, which computes any "
            "vehicle\n");
}

TEST(FlatUnsupported, NameTheBodyThatIsNoBogie) {
  Vehicle vehicle = paperVehicle();
  vehicle.bodies.push_back(body("tender", 2e3, 9.0, std::nullopt, {Motion::kZ}));
  vehicle.suspensions.push_back(suspension("tender_spring", "primary", "tender", "wheelset_1", 9.0));
  EXPECT_EQ(unsupportedOf(vehicle),
            "error: <vehicle><body name=\"tender\">: is neither the carbody nor a bogie under it; the form flat "
            "computes no other body; take the form matrix, which computes any vehicle\n"
            "error: <vehicle><wheelset name=\"wheelset_1\">: carries 2 bodies (\"front_bogie\", \"tender\"); the "
            "form flat computes wheelsets that carry one bogie each; take the form matrix, which computes any "
            "vehicle\n");
}

TEST(FlatUnsupported, NameTheSuspensionBetweenBogies) {
  Vehicle vehicle = paperVehicle();
  vehicle.suspensions.push_back(suspension("link", "primary", "front_bogie", "rear_bogie", 0.0));
  EXPECT_EQ(unsupportedOf(vehicle),
            "error: <vehicle><suspension name=\"link\">: joins the bogie \"front_bogie\" to another body; the form "
            "flat computes bogies that stand on wheelsets; take the form matrix, which computes any vehicle\n"
            "error: <vehicle><body name=\"rear_bogie\">: carries bodies by 2 suspensions (\"secondary_rear\", "
            "\"link\"); the form flat computes one for each bogie; take the form matrix, which computes any vehicle\n");
}

TEST(FlatUnsupported, NameTheVehicleWithoutBogies) {
  Vehicle vehicle;
  vehicle.name = "trolley";
  vehicle.elements = {element("spring", 1e6, 0.0)};
  vehicle.bodies = {body("deck", 1e3, 0.0, 1e3, {Motion::kZ, Motion::kPitch})};
  vehicle.wheelsets = {wheelset("ahead", 2.0), wheelset("behind", -2.0)};
  vehicle.suspensions = {suspension("s_ahead", "spring", "deck", "ahead", 2.0),
                         suspension("s_behind", "spring", "deck", "behind", -2.0)};
  EXPECT_EQ(unsupportedOf(vehicle),
            "error: <vehicle name=\"trolley\">: has no body that stands on other bodies; the form flat computes a "
            "carbody on two bogies; take the form matrix, which computes any vehicle\n");
}

TEST(PrintedVariants, RefuseAnAsymmetricVehicleNamingWhatDiffers) {
  EXPECT_EQ(
      unsupportedOf(asymmetricVehicle(), FlatVariant::kPrinted7),
      "error: <vehicle><body name=\"rear_bogie\">: has mass 7500 kg, \"front_bogie\" has 10200 kg; the printed "
      "equations have one value for both; give both the same, or take the form flat\n"
      "error: <vehicle><suspension name=\"secondary_rear\">: has stiffness 1900000 N/m, \"secondary_front\" has "
      "3100000 N/m; the printed equations have one value for both; give both the same, or take the form flat\n"
      "error: <vehicle><suspension name=\"secondary_rear\">: has damping 85000 N*s/m, \"secondary_front\" has 60000 "
      "N*s/m; the printed equations have one value for both; give both the same, or take the form flat\n"
      "error: <vehicle><suspension name=\"secondary_rear\">: stands 4.8 m behind the carbody's centre of gravity, "
      "\"secondary_front\" 3.7 m ahead; the printed equations have one lever arm for both; give both the same, or "
      "take the form flat\n"
      "error: <vehicle><suspension name=\"primary_2\">: has stiffness 3400000 N/m, \"primary_1\" has 2700000 N/m; "
      "the printed equations have one value for both; give both the same, or take the form flat\n"
      "error: <vehicle><suspension name=\"primary_2\">: has damping 33000 N*s/m, \"primary_1\" has 21000 N*s/m; the "
      "printed equations have one value for both; give both the same, or take the form flat\n"
      "error: <vehicle><suspension name=\"primary_3\">: has stiffness 2200000 N/m, \"primary_1\" has 2700000 N/m; "
      "the printed equations have one value for both; give both the same, or take the form flat\n"
      "error: <vehicle><suspension name=\"primary_3\">: has damping 45000 N*s/m, \"primary_1\" has 21000 N*s/m; the "
      "printed equations have one value for both; give both the same, or take the form flat\n"
      "error: <vehicle><suspension name=\"primary_4\">: has stiffness 3900000 N/m, \"primary_1\" has 2700000 N/m; "
      "the printed equations have one value for both; give both the same, or take the form flat\n"
      "error: <vehicle><suspension name=\"primary_4\">: has damping 12000 N*s/m, \"primary_1\" has 21000 N*s/m; the "
      "printed equations have one value for both; give both the same, or take the form flat\n");
}

TEST(PrintedVariants, RefuseStaticLoadsAtHeights) {
  EXPECT_EQ(unsupportedOf(heightsVehicle(0.5), FlatVariant::kLiteral),
            "error: <vehicle><suspension name=\"secondary_front\">: ends 0.5 m below the carbody's centre of "
            "gravity; the printed equations carry no static loads at heights; remove the heights, or take the form "
            "flat\n"
            "error: <vehicle><suspension name=\"secondary_rear\">: ends 0.5 m below the carbody's centre of gravity; "
            "the printed equations carry no static loads at heights; remove the heights, or take the form flat\n");
}

TEST(BuildFlatForm, ThrowsTheUnsupported) {
  try {
    static_cast<void>(buildFlatForm(compile(bogiePitchVehicle(), 9.81)));
    FAIL() << "a pitching bogie was accepted";
  } catch (const InvalidInput& wrong) {
    EXPECT_EQ(wrong.problems().text(), unsupportedOf(bogiePitchVehicle()));
  }
}

// Static loads matter where the form fits: a carbody that lifts a wheelset is refused as restOf() does.
TEST(BuildFlatForm, RefusesAVehicleThatTipsOver) {
  Vehicle vehicle = paperVehicle();
  vehicle.bodies[0].x = 9.0;
  EXPECT_THROW(static_cast<void>(buildFlatForm(compile(vehicle, 9.81))), InvalidInput);
}

}  // namespace
}  // namespace vehicle::test
