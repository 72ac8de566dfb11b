#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "libvehicle/definition/vehicle.h"
#include "tests/support/vehicles.h"

// Every message of check(Vehicle), provoked, whole text. The paper's vehicle as if read from a file:
//   1 vehicle | 2 3 elements primary, secondary | 4 5 6 bodies | 7..10 wheelsets | 11 12 secondaries, 13..16 primaries
namespace vehicle {
namespace {

using test::named;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

Vehicle numbered(Vehicle made = test::paperVehicle()) {
  int line = 1;
  const auto number = [&](Origin& origin) {
    origin.file = "coach.xml";
    origin.line = line++;
  };
  number(made.origin);
  for (Element& each : made.elements) number(each.origin);
  for (Body& each : made.bodies) number(each.origin);
  for (Wheelset& each : made.wheelsets) number(each.origin);
  for (Suspension& each : made.suspensions) number(each.origin);
  return made;
}

std::string problemsAfter(const std::function<void(Vehicle&)>& change) {
  Vehicle made = numbered();
  change(made);
  return check(made).text();
}

std::string bodyProblem(const std::function<void(Body&)>& change) {
  return problemsAfter([&](Vehicle& made) { change(named(made.bodies, "front_bogie")); });
}

std::string wheelsetProblem(const std::function<void(Wheelset&)>& change) {
  return problemsAfter([&](Vehicle& made) { change(named(made.wheelsets, "wheelset_1")); });
}

std::string suspensionProblem(const std::function<void(Suspension&)>& change) {
  return problemsAfter([&](Vehicle& made) { change(named(made.suspensions, "primary_1")); });
}

TEST(CheckVehicle, TheVehiclesOfTheTestsAreInOrder) {
  for (const Vehicle& each :
       {test::paperVehicle(), test::paperVehicle(686465.5), test::bogiePitchVehicle(), test::contactVehicle(),
        test::hertzVehicle(), test::asymmetricVehicle(), test::asymmetricBogiePitchVehicle(), test::heightsVehicle(),
        test::bogiePitchHeightsVehicle(), numbered()}) {
    EXPECT_EQ(check(each).text(), "") << each.name;
  }
}

TEST(CheckVehicle, NamesArePresentProperAndNotReserved) {
  EXPECT_EQ(bodyProblem([](Body& body) { body.name = ""; }),
            "coach.xml:5: error: <vehicle><body>: has no name; name=\"...\" is required\n");
  for (const char* name : {"a.b", "a b", "a/b", "\u00fcber", "a%"}) {
    EXPECT_EQ(suspensionProblem([&](Suspension& each) { each.name = name; }),
              "coach.xml:13: error: <vehicle><suspension>: name=\"" + std::string(name) +
                  "\"; a name is made of the letters a-z and A-Z, digits, \"_\" and \"-\"\n");
  }
  EXPECT_EQ(suspensionProblem([](Suspension& each) { each.name = "two\nlines"; }),
            "coach.xml:13: error: <vehicle><suspension>: name=\"two?lines\"; "
            "a name is made of the letters a-z and A-Z, digits, \"_\" and \"-\"\n");
  for (const char* name : {"scenario", "speed"}) {
    EXPECT_EQ(suspensionProblem([&](Suspension& each) { each.name = name; }),
              "coach.xml:13: error: <vehicle><suspension>: name=\"" + std::string(name) +
                  "\"; the word has a meaning of its own in a study; choose another name\n");
  }
  EXPECT_EQ(problemsAfter([](Vehicle& made) { made.name = ""; }),
            "coach.xml:1: error: <vehicle>: has no name; name=\"...\" is required\n");
}

TEST(CheckVehicle, NamesAreUniqueAcrossAllKindsOfParts) {
  EXPECT_EQ(suspensionProblem([](Suspension& each) { each.name = "primary"; }),
            "coach.xml:13: error: <vehicle><suspension>: name=\"primary\" is already the name of an element (line 2); "
            "names are unique in a file\n");
  EXPECT_EQ(problemsAfter([](Vehicle& made) {
              made.wheelsets[1].name = "wheelset_1";
              made.suspensions[3].lower = "wheelset_1";
            }),
            "coach.xml:8: error: <vehicle><wheelset>: name=\"wheelset_1\" is already the name of a wheelset (line 7); "
            "names are unique in a file\n");
  // The later line is the culprit, whatever the kinds.
  EXPECT_EQ(problemsAfter([](Vehicle& made) {
              Group group;
              group.name = "carbody";
              group.origin.file = "coach.xml";
              group.origin.line = 17;
              made.groups.push_back(group);
            }),
            "coach.xml:17: error: <vehicle><group>: name=\"carbody\" is already the name of a body (line 4); "
            "names are unique in a file\n");
}

TEST(CheckVehicle, ReferencesLeadToAPartOfTheRightKind) {
  EXPECT_EQ(suspensionProblem([](Suspension& each) { each.upper = "front_bogy"; }),
            "coach.xml:13: error: <vehicle><suspension>: upper=\"front_bogy\" names no part of this vehicle; "
            "a body is expected; did you mean \"front_bogie\"?\n");
  EXPECT_EQ(suspensionProblem([](Suspension& each) { each.upper = "wheelset_2"; }),
            "coach.xml:13: error: <vehicle><suspension>: upper=\"wheelset_2\" is a wheelset (line 8); "
            "a body is expected\n");
  EXPECT_EQ(suspensionProblem([](Suspension& each) { each.lower = "wheelset1"; }),
            "coach.xml:13: error: <vehicle><suspension>: lower=\"wheelset1\" names no part of this vehicle; "
            "a body or a wheelset is expected; did you mean \"wheelset_1\"?\n");
  EXPECT_EQ(suspensionProblem([](Suspension& each) { each.element = "Primary"; }),
            "coach.xml:13: error: <vehicle><suspension>: element=\"Primary\" names no part of this vehicle; "
            "an element is expected; did you mean \"primary\"?\n");
  EXPECT_EQ(suspensionProblem([](Suspension& each) { each.element = ""; }),
            "coach.xml:13: error: <vehicle><suspension>: element=\"\" names no part of this vehicle; "
            "an element is expected\n");
  EXPECT_EQ(suspensionProblem([](Suspension& each) { each.group = "front"; }),
            "coach.xml:13: error: <vehicle><group><suspension>: group=\"front\" names no part of this vehicle; "
            "a group is expected\n");
  EXPECT_EQ(bodyProblem([](Body& body) { body.group = "front"; }),
            "coach.xml:5: error: <vehicle><group><body>: group=\"front\" names no part of this vehicle; "
            "a group is expected\n");
  EXPECT_EQ(wheelsetProblem([](Wheelset& wheelset) { wheelset.group = "carbody"; }),
            "coach.xml:7: error: <vehicle><group><wheelset>: group=\"carbody\" is a body (line 4); "
            "a group is expected\n");
  EXPECT_EQ(problemsAfter([](Vehicle& made) {
              Point point;
              point.name = "floor";
              point.body = "carbodies";
              point.origin.file = "coach.xml";
              point.origin.line = 17;
              made.points.push_back(point);
            }),
            "coach.xml:17: error: <vehicle><point>: body=\"carbodies\" names no part of this vehicle; "
            "a body is expected; did you mean \"carbody\"?\n");
}

TEST(CheckVehicle, NumbersAreFiniteAndWithinTheirBounds) {
  const std::string body = "coach.xml:5: error: <vehicle><body>: ";
  EXPECT_EQ(bodyProblem([](Body& b) { b.mass = 0.0; }), body + "mass=\"0 kg\"; must be > 0\n");
  EXPECT_EQ(bodyProblem([](Body& b) { b.mass = -9e3; }), body + "mass=\"-9 t\"; must be > 0\n");
  EXPECT_EQ(bodyProblem([](Body& b) { b.mass = kNan; }), body + "mass=\"nan\"; must be finite\n");
  EXPECT_EQ(bodyProblem([](Body& b) { b.mass = 1e-70; }),
            body + "mass=\"1e-73 t\"; must be at least 1e-60 in SI units\n");
  EXPECT_EQ(bodyProblem([](Body& b) { b.x = kInf; }), body + "x=\"inf\"; must be finite\n");
  EXPECT_EQ(bodyProblem([](Body& b) { b.x = -kInf; }), body + "x=\"-inf\"; must be finite\n");
  EXPECT_EQ(bodyProblem([](Body& b) { b.x = 1e70; }), body + "x=\"1e70 m\"; must be at most 1e60 in SI units\n");
  EXPECT_EQ(bodyProblem([](Body& b) { b.pitch_inertia = -1.0; }), body + "pitch_inertia=\"-1 kg*m^2\"; must be >= 0\n");

  const std::string wheelset = "coach.xml:7: error: <vehicle><wheelset>: ";
  EXPECT_EQ(wheelsetProblem([](Wheelset& w) { w.x = kNan; }), wheelset + "x=\"nan\"; must be finite\n");
  EXPECT_EQ(wheelsetProblem([](Wheelset& w) { w.mass = 0.0; }), wheelset + "mass=\"0 kg\"; must be > 0\n");
  EXPECT_EQ(wheelsetProblem([](Wheelset& w) { w.load = -1e3; }), wheelset + "load=\"-1 kN\"; must be > 0\n");
  const auto onContact = [](Wheelset& w, double stiffness, double damping) {
    w.mass = 1500.0;
    w.contact_stiffness = stiffness;
    w.contact_damping = damping;
  };
  EXPECT_EQ(wheelsetProblem([&](Wheelset& w) { onContact(w, 0.0, 0.0); }),
            wheelset + "contact_stiffness=\"0 kN/m\"; must be > 0\n");
  EXPECT_EQ(wheelsetProblem([&](Wheelset& w) { onContact(w, 1e9, -1e3); }),
            wheelset + "contact_damping=\"-1 kN*s/m\"; must be >= 0\n");
  EXPECT_EQ(wheelsetProblem([](Wheelset& w) {
              w.mass = 1500.0;
              w.hertz_constant = -1e9;
            }),
            wheelset + "hertz_constant=\"-1 GN/m^1.5\"; must be > 0\n");

  const std::string suspension = "coach.xml:13: error: <vehicle><suspension>: ";
  EXPECT_EQ(suspensionProblem([](Suspension& s) { s.x = kNan; }), suspension + "x=\"nan\"; must be finite\n");
  EXPECT_EQ(suspensionProblem([](Suspension& s) { s.y = kNan; }), suspension + "y=\"nan\"; must be finite\n");
  EXPECT_EQ(suspensionProblem([](Suspension& s) { s.preload = kInf; }),
            suspension + "preload=\"inf\"; must be finite\n");

  const auto elementProblem = [](double stiffness, double damping) {
    return problemsAfter([&](Vehicle& made) { made.elements.push_back(test::element("spare", stiffness, damping)); });
  };
  const std::string element = "error: <vehicle><element name=\"spare\">: ";
  EXPECT_EQ(elementProblem(-1e3, 0.0), element + "stiffness_z=\"-1 kN/m\"; must be >= 0\n");
  EXPECT_EQ(elementProblem(0.0, -1e3), element + "damping_z=\"-1 kN*s/m\"; must be >= 0\n");
  EXPECT_EQ(elementProblem(0.0, 0.0), "");

  EXPECT_EQ(problemsAfter([](Vehicle& made) { made.groups.push_back({"front", kNan, {}}); }),
            "error: <vehicle><group name=\"front\">: x=\"nan\"; must be finite\n");
  EXPECT_EQ(problemsAfter([](Vehicle& made) { made.points.push_back({"floor", "", "carbody", kNan, {}}); }),
            "error: <vehicle><point name=\"floor\">: x=\"nan\"; must be finite\n");
}

TEST(CheckVehicle, ABodyMovesInAtLeastOneWayAndInEachOnce) {
  EXPECT_EQ(bodyProblem([](Body& b) { b.motion = {}; }),
            "coach.xml:5: error: <vehicle><body>: motion is empty; "
            "name the motions the body has, e.g. motion=\"z pitch\"\n");
  EXPECT_EQ(bodyProblem([](Body& b) { b.motion = {Motion::kZ, Motion::kRoll, Motion::kZ, Motion::kZ}; }),
            "coach.xml:5: error: <vehicle><body>: motion names \"z\" twice; name each motion once\n");
  EXPECT_EQ(problemsAfter([](Vehicle& made) {
              for (Body& body : made.bodies) body.motion = {Motion::kX, Motion::kY, Motion::kRoll, Motion::kYaw};
            }),
            "coach.xml:1: error: <vehicle>: no body has the motion z or pitch; "
            "let at least one move in the vertical plane, e.g. motion=\"z\"\n");
}

TEST(CheckVehicle, ABodyThatPitchesHasAPositivePitchInertia) {
  const auto pitching = [](std::optional<double> inertia) {
    return bodyProblem([&](Body& b) {
      b.motion = {Motion::kZ, Motion::kPitch};
      b.pitch_inertia = inertia;
    });
  };
  EXPECT_EQ(pitching(std::nullopt),
            "coach.xml:5: error: <vehicle><body>: pitches (motion names \"pitch\") without pitch_inertia; "
            "give it, e.g. pitch_inertia=\"70 t*m^2\"\n");
  EXPECT_EQ(pitching(0.0), "coach.xml:5: error: <vehicle><body>: pitch_inertia=\"0 kg*m^2\"; must be > 0\n");
  EXPECT_EQ(pitching(-1.0), "coach.xml:5: error: <vehicle><body>: pitch_inertia=\"-1 kg*m^2\"; must be > 0\n");
  EXPECT_EQ(pitching(1476.0), "");
}

TEST(CheckVehicle, AContactNeedsMassAndOneSpring) {
  const std::string wheelset = "coach.xml:7: error: <vehicle><wheelset>: ";
  EXPECT_EQ(wheelsetProblem([](Wheelset& w) { w.contact_stiffness = 1e9; }),
            wheelset + "has contact_stiffness but no mass; "
                       "give its mass, or leave the contact out: then it follows the rail\n");
  EXPECT_EQ(wheelsetProblem([](Wheelset& w) { w.hertz_constant = 90e9; }),
            wheelset + "has hertz_constant but no mass; "
                       "give its mass, or leave the contact out: then it follows the rail\n");
  EXPECT_EQ(wheelsetProblem([](Wheelset& w) {
              w.mass = 1500.0;
              w.contact_stiffness = 1e9;
              w.hertz_constant = 90e9;
            }),
            wheelset + "has contact_stiffness and hertz_constant; "
                       "give one of them: the contact is linear or Hertz's\n");
  EXPECT_EQ(wheelsetProblem([](Wheelset& w) {
              w.mass = 1500.0;
              w.contact_damping = 1e3;
            }),
            wheelset + "has contact_damping but no contact spring; "
                       "give contact_stiffness or hertz_constant, or leave contact_damping out\n");
}

TEST(CheckVehicle, ASuspensionJoinsTwoPartsOnOneOrTwoSides) {
  const std::string suspension = "coach.xml:13: error: <vehicle><suspension>: ";
  EXPECT_EQ(suspensionProblem([](Suspension& s) { s.sides = 3; }), suspension + "sides=\"3\"; must be 1 or 2\n");
  EXPECT_EQ(suspensionProblem([](Suspension& s) { s.sides = 2; }),
            suspension + "sides=\"2\" without y; give y, half the distance across the track, e.g. y=\"1 m\"\n");
  EXPECT_EQ(problemsAfter([](Vehicle& made) {
              Suspension loop = made.suspensions[2];
              loop.name = "loop";
              loop.lower = loop.upper;
              made.suspensions.push_back(loop);
            }),
            suspension + "upper and lower are both \"front_bogie\"; a suspension joins two parts\n");
}

TEST(CheckVehicle, EveryBodyStandsOnSpringsAndEveryWheelsetIsStoodOn) {
  // Dampers carry nothing; the rear bogie still does not hold the front one up, but the carbody stands.
  EXPECT_EQ(problemsAfter([](Vehicle& made) {
              made.elements.push_back(test::element("damper", 0.0, 30e3));
              for (Suspension& each : made.suspensions) {
                if (each.name != "secondary_rear" && each.name != "primary_3") each.element = "damper";
              }
            }),
            "coach.xml:5: error: <vehicle><body>: \"front_bogie\" stands on nothing: no chain of springs leads from it "
            "down to a wheelset; add a <suspension> under it whose element has stiffness_z > 0\n");
  EXPECT_EQ(problemsAfter([](Vehicle& made) { made.suspensions.erase(made.suspensions.begin() + 2); }),
            "coach.xml:7: error: <vehicle><wheelset>: nothing stands on \"wheelset_1\": no <suspension> names it as "
            "its lower; add the <suspension>, or remove the wheelset\n");
  // A body that does not rise needs no carrying.
  EXPECT_EQ(problemsAfter([](Vehicle& made) {
              made.bodies.push_back(test::body("sledge", 100.0, 0.0, std::nullopt, {Motion::kX}));
            }),
            "");
}

TEST(CheckVehicle, HeightsAreGivenForAllPartsOrForNone) {
  Vehicle made = numbered(test::heightsVehicle());
  named(made.bodies, "rear_bogie").z = std::nullopt;
  named(made.suspensions, "secondary_front").z_upper = std::nullopt;
  named(made.suspensions, "primary_1").z_lower = std::nullopt;
  named(made.suspensions, "primary_2").z_lower = std::nullopt;
  named(made.suspensions, "primary_2").z_upper = std::nullopt;
  EXPECT_EQ(check(made).text(),
            "coach.xml:6: error: <vehicle><body>: has no z (and in 3 more places: lines 11, 13, 14), but the body "
            "\"carbody\" (line 4) has a height; heights are given for all bodies and both ends of all suspensions, or for "
            "none\n");
  // The axle's own height is free to be left out.
  made = test::heightsVehicle();
  for (Wheelset& each : made.wheelsets) each.z = std::nullopt;
  EXPECT_EQ(check(made).text(), "");
  // Where most parts have none, the one that has is the odd one.
  EXPECT_EQ(wheelsetProblem([](Wheelset& w) { w.z = 0.46; }).substr(0, 97),
            "coach.xml:7: error: <vehicle><wheelset>: has a height, but the body \"carbody\" (line 4) has no z; ");
}

TEST(CheckVehicle, AVehicleHasBodiesWheelsetsAndSuspensions) {
  Vehicle made;
  made.name = "empty";
  EXPECT_EQ(check(made).text(),
            "error: <vehicle name=\"empty\">: has no <body>; a vehicle has at least one\n"
            "error: <vehicle name=\"empty\">: has no <wheelset>; a vehicle has at least one\n"
            "error: <vehicle name=\"empty\">: has no <suspension>; bodies stand on suspensions\n");
}

TEST(CheckVehicle, AllProblemsComeInOnePassInTheOrderOfTheFile) {
  EXPECT_EQ(problemsAfter([](Vehicle& made) {
              named(made.suspensions, "primary_4").x = kNan;
              named(made.wheelsets, "wheelset_3").mass = -1.0;
              named(made.bodies, "carbody").mass = 0.0;
              named(made.suspensions, "secondary_rear").upper = "carbdy";
            }),
            "coach.xml:4: error: <vehicle><body>: mass=\"0 kg\"; must be > 0\n"
            "coach.xml:9: error: <vehicle><wheelset>: mass=\"-1 kg\"; must be > 0\n"
            "coach.xml:12: error: <vehicle><suspension>: upper=\"carbdy\" names no part of this vehicle; "
            "a body is expected; did you mean \"carbody\"?\n"
            "coach.xml:16: error: <vehicle><suspension>: x=\"nan\"; must be finite\n");
}

// 20 000 bodies on springs that lead nowhere: a check that compares all with all would take minutes.
TEST(CheckVehicle, AHugeFileIsJudgedInLinearTime) {
  Vehicle made = test::paperVehicle();
  for (int i = 0; i < 20'000; ++i) {
    const std::string number = std::to_string(i);
    made.bodies.push_back(test::body("body_" + number, 1.0, 0.0, std::nullopt, {Motion::kZ}));
    made.suspensions.push_back(
        test::suspension("spring_" + number, "primary", "body_" + number, "lost_" + number, 0.0));
  }
  EXPECT_EQ(check(made).size(), 20'000u);
  for (Suspension& each : made.suspensions) {
    if (each.lower.starts_with("lost")) each.lower = "wheelset_1";
  }
  EXPECT_EQ(check(made).size(), 0u);
}

}  // namespace
}  // namespace vehicle
