#include "libvehicle/xml/reader.h"

#include <gtest/gtest.h>

#include "tests/xml/files.h"

namespace vehicle {
namespace {

using test::Spoilt;
using test::withLine;

TEST(VehicleReader, WrongValuesAreToldWithPlaceRuleAndRemedy) {
  const std::vector<Spoilt> cases = {
      {2, R"(<element name="primary" stiffness_z="3040 kN/m" damping_z="30 kN/m"/>)",
       R"(a.xml:2: error: <vehicle><element>: damping_z="30 kN/m" is a stiffness; a damping is expected, e.g. "30 kN*s/m"
)"},
      {2, R"(<element name="primary" stiffness_z="3040" damping_z="30 kN*s/m"/>)",
       R"(a.xml:2: error: <vehicle><element>: stiffness_z="3040" has no unit; a stiffness is expected, e.g. "3040 kN/m"
)"},
      {2, R"(<element name="primary" stiffness_z="3040 kM/m" damping_z="30 kN*s/m"/>)",
       R"(a.xml:2: error: <vehicle><element>: stiffness_z="3040 kM/m" has the unknown unit "kM"; a stiffness is expected, e.g. "3040 kN/m"; did you mean "3040 kN/m"?
)"},
      {2, R"(<element name="primary" stiffness_z="much kN/m" damping_z="30 kN*s/m"/>)",
       R"(a.xml:2: error: <vehicle><element>: stiffness_z="much kN/m" is not a number; a stiffness is expected, e.g. "3040 kN/m"
)"},
      {2, R"(<element name="primary" stiffness_z="" damping_z="30 kN*s/m"/>)",
       R"(a.xml:2: error: <vehicle><element>: stiffness_z="" is empty; a stiffness is expected, e.g. "3040 kN/m"
)"},
      {2, R"(<element name="primary" stiffness_z="-1 kN/m" damping_z="30 kN*s/m"/>)",
       R"(a.xml:2: error: <vehicle><element>: stiffness_z="-1 kN/m"; must be >= 0
)"},
      {2, R"(<element name="primary" stiffness_z="nan N/m" damping_z="inf N*s/m"/>)",
       R"(a.xml:2: error: <vehicle><element>: stiffness_z="nan N/m" is not finite; a stiffness is expected, e.g. "3040 kN/m"
a.xml:2: error: <vehicle><element>: damping_z="inf N*s/m" is not finite; a damping is expected, e.g. "30 kN*s/m"
)"},
      {2, R"(<element name="primary" stiffness_z="1e999 N/m"/>)",
       R"(a.xml:2: error: <vehicle><element>: stiffness_z="1e999 N/m" is not finite; a number holds up to 1.8e308 in SI units
)"},
      {3, R"(<body name="frame"
        mass="0 t"
        motion="z"/>)",
       R"(a.xml:4: error: <vehicle><body>: mass="0 t"; must be > 0
)"},
      {3, R"(<body name="frame" mass="-9 t" motion="z pitch"/>)",
       R"(a.xml:3: error: <vehicle><body>: mass="-9 t"; must be > 0
a.xml:3: error: <vehicle><body>: pitches (motion names "pitch") without pitch_inertia; give it, e.g. pitch_inertia="70 t*m^2"
)"},
      {3, R"(<body name="frame" mass="9 t" motion="z" roll_inertia="4 t" y="1 s"/>)",
       R"(a.xml:3: error: <vehicle><body>: roll_inertia="4 t" is a mass; a moment of inertia is expected, e.g. "70 t*m^2"
a.xml:3: error: <vehicle><body>: y="1 s" is a time; a length is expected, e.g. "3.725 m"
)"},
      {3, R"(<body name="frame" mass="9 t" motion=""/>)",
       R"(a.xml:3: error: <vehicle><body>: motion="" is empty; write one or more of "x", "y", "z", "roll", "pitch", "yaw"
)"},
      {3, R"(<body name="frame" mass="9 t" motion="z z"/>)",
       R"(a.xml:3: error: <vehicle><body>: motion="z z": "z" stands twice; write it once
)"},
      {3, R"(<body name="frame" mass="9 t" motion="z pich"/>)",
       R"(a.xml:3: error: <vehicle><body>: motion="z pich": "pich" is none of "x", "y", "z", "roll", "pitch", "yaw"; did you mean "pitch"?
)"},
      {3, R"(<body name="frame" mass="9 t" motion="up"/>)",
       R"(a.xml:3: error: <vehicle><body>: motion="up": "up" is none of "x", "y", "z", "roll", "pitch", "yaw"; write one of these
)"},
      {3, R"(<body name="front frame" mass="9 t" motion="z"/>
  <body name="" mass="9 t" motion="z"/>)",
       R"(a.xml:3: error: <vehicle><body>: name="front frame" is no name; names have up to 64 letters a-z, A-Z, digits, "_" and "-", and begin with a letter or digit
a.xml:4: error: <vehicle><body>: name="" is no name; names have up to 64 letters a-z, A-Z, digits, "_" and "-", and begin with a letter or digit
)"},
      {5, R"(<suspension name="spring" element="primary" upper="frame" lower="axle" x="1 m" sides="3" y="1 m"/>)",
       R"(a.xml:5: error: <vehicle><suspension>: sides="3"; must be from 1 to 2
)"},
      {5, R"(<suspension name="spring" element="primary" upper="frame" lower="axle" x="1 m" sides="two"/>)",
       R"(a.xml:5: error: <vehicle><suspension>: sides="two" is no whole number; must be from 1 to 2
)"},
      {5, R"(<suspension name="spring" element="primary" upper="frame" lower="axle" x="1 m" sides="99999999999"/>)",
       R"(a.xml:5: error: <vehicle><suspension>: sides="99999999999"; must be from 1 to 2
)"},
      {5,
       R"(<suspension name="spring" element="primary" upper="frame" lower="axle" x="1 m" z="0.5 m" z_lower="0.4 m"/>)",
       R"(a.xml:3: error: <vehicle><body>: has no z, but the suspension "spring" (line 5) has a height; heights are given for all bodies and both ends of all suspensions, or for none
a.xml:5: error: <vehicle><suspension>: "z" and "z_lower" are both given, and z stands for z_upper, z_lower; remove one of them
)"},
      {5, R"(<suspension name="spring" element="primary" upper="frame" lower="!" x="1 m"/>)",
       R"(a.xml:5: error: <vehicle><suspension>: lower="!" is no name; names have up to 64 letters a-z, A-Z, digits, "_" and "-", and begin with a letter or digit
)"},
      {3, R"(<body name="frame" mass="9 t" motion="z"/>
  <point name="ppppppppppppppppppppppppppppppppppppppppppppppppppppppppppppppppp" body="frame"/>)",
       R"(a.xml:4: error: <vehicle><point>: name="pppppppppppppppppppppppppppppppppppppppppppppppppppppppppppp..." is no name; names have up to 64 letters a-z, A-Z, digits, "_" and "-", and begin with a letter or digit
)"},
  };
  for (const Spoilt& each : cases) {
    const auto outcome = readVehicleText(withLine(test::kVehicleLines, each.line, each.instead), "a.xml");
    EXPECT_EQ(outcome.problems.text(), each.says);
    EXPECT_FALSE(outcome.value.has_value()) << each.instead;
  }
}

TEST(VehicleReader, WhatMayNotStandThereIsToldWithTheNearestRightName) {
  const std::vector<Spoilt> cases = {
      {2, R"(<element nam="primary" stiffness_z="3040 kN/m" damping_z="30 kN*s/m"/>)",
       R"(a.xml:2: error: <vehicle><element>: attribute "nam" is unknown; did you mean "name"?
)"},
      {2, R"(<element name="primary" stiffness_z="3040 kN/m" stifness_x="30 kN*s/m"/>)",
       R"(a.xml:2: error: <vehicle><element>: attribute "stifness_x" is unknown; did you mean "stiffness_x"?
a.xml:2: error: <vehicle><element>: stiffness_x="30 kN*s/m" is a damping; a stiffness is expected, e.g. "3040 kN/m"
)"},
      {2, R"(<element name="primary" stiffness_z="3040 kN/m" colour="red"/>)",
       R"(a.xml:2: error: <vehicle><element>: attribute "colour" is unknown; what may still stand here: damping_z, stiffness_x, stiffness_y, stiffness_roll, stiffness_pitch, stiffness_yaw, damping_x, damping_y, damping_roll, damping_pitch, damping_yaw
)"},
      {2, R"(<element name="primary" stiffness_z="3040 kN/m" stiffness_z="1 kN/m"/>)",
       R"(a.xml:2: error: <element>: attribute "stiffness_z" stands twice; remove one of them
)"},
      {2, R"(<elemnt name="primary" stiffness_z="3040 kN/m" damping_z="30 kN/m"/>)",
       R"(a.xml:2: error: <vehicle>: element <elemnt> is unknown; did you mean <element>?
a.xml:2: error: <vehicle><element>: damping_z="30 kN/m" is a stiffness; a damping is expected, e.g. "30 kN*s/m"
)"},
      {3, R"(<body name="frame" motion="z"/>)",
       R"(a.xml:3: error: <vehicle><body>: attribute "mass" is missing; write e.g. mass="57 t"
)"},
      {3, R"(<body mass="9 t" motion="z"/>)",
       R"(a.xml:3: error: <vehicle><body>: attribute "name" is missing; write e.g. name="carbody"
)"},
      {3, R"(<body name="frame" mass="9 t" motion="z">heavy</body>)",
       R"(a.xml:3: error: <vehicle><body>: the text "heavy" stands here; values are attributes; only <title> and <source> hold text
)"},
      {3, R"(<body name="frame" mass="9 t" motion="z"><wheel/></body>)",
       R"(a.xml:3: error: <vehicle><body>: element <wheel> is unknown; nothing may stand here
)"},
      {3, R"(<flywheel name="frame" mass="9 t" motion="z"/>)",
       R"(a.xml:3: error: <vehicle>: element <flywheel> is unknown; what may stand here: <title>, <source>, <element>, <body>, <group>, <wheelset>, <suspension>, <point>
)"},
      {3, R"(<harmonic wavelength="25 m" amplitude="5 mm"/>)",
       R"(a.xml:3: error: <vehicle>: element <harmonic> has no meaning here; it may stand in <track>
)"},
      {3, R"(<title>A</title>
  <title>B</title>
  <body name="frame" mass="9 t" motion="z"/>)",
       R"(a.xml:4: error: <vehicle>: <title> stands a second time, first in line 3; remove one of them
)"},
      {3, R"(<title lang="en">A <b>bold</b> name</title>
  <body name="frame" mass="9 t" motion="z"/>)",
       R"(a.xml:3: error: <vehicle><title>: attribute "lang" is unknown; remove it
a.xml:3: error: <vehicle><title>: element <b> stands inside a text; write text alone
)"},
      {3, R"(<group name="g"><group name="h"><body name="frame" mass="9 t" motion="z"/></group></group>)",
       R"(a.xml:3: error: <vehicle><group>: <group> stands inside <group>; close <group> before it
)"},
      {3, R"(<group name="g"><body name="frame" mass="9 t" motion="z"/><title>x</title></group>)",
       R"(a.xml:3: error: <vehicle><group>: <title> stands inside <group>; close <group> before it
)"},
      {3, R"(<group name="g"><body name="frame" mass="9 t" motion="z"/><bodi/><x/></group>)",
       R"(a.xml:3: error: <vehicle><group>: element <bodi> is unknown; did you mean <body>?
a.xml:3: error: <vehicle><group><body>: attribute "name" is missing; write e.g. name="carbody"
a.xml:3: error: <vehicle><group><body>: attribute "mass" is missing; write e.g. mass="57 t"
a.xml:3: error: <vehicle><group><body>: attribute "motion" is missing; write e.g. motion="z pitch"
a.xml:3: error: <vehicle><group>: element <x> is unknown; what may stand here: <body>, <wheelset>, <suspension>, <point>
)"},
      {3, R"(<body name="frame" mass="9 t" motion="z"/> some words
 over two lines)",
       R"(a.xml:3: error: <vehicle>: the text "some words over two lines" stands here; values are attributes; only <title> and <source> hold text
)"},
      {1, R"(<vehicle name="v">)",
       R"(a.xml:1: error: <vehicle>: attribute "format" is missing; write e.g. format="1"
)"},
      {1, R"(<vehicle name="v" format="2" colour="red">)",
       R"(a.xml:1: error: <vehicle>: format="2" is unknown to this program; it reads format="1"
)"},
      {1, R"(<vehicle format="1">)",
       R"(a.xml:1: error: <vehicle>: attribute "name" is missing; write e.g. name="coach"
)"},
      {1, R"(<vehicle name="v" format="1" gravity="9.81 m/s^2">)",
       R"(a.xml:1: error: <vehicle>: attribute "gravity" is unknown; remove it
)"},
  };
  for (const Spoilt& each : cases) {
    const auto outcome = readVehicleText(withLine(test::kVehicleLines, each.line, each.instead), "a.xml");
    EXPECT_EQ(outcome.problems.text(), each.says);
    EXPECT_FALSE(outcome.value.has_value()) << each.instead;
  }
}

// The words are those of definition's check(); here it counts that they come, in place, and without echoes of
// what the reader has told already.
TEST(VehicleReader, ContradictionsAreToldBesideWrongValues) {
  const std::vector<Spoilt> cases = {
      {3, R"(<body name="frame" mass="9 t" motion="z"/>
  <body name="frame" mass="9 t" motion="z"/>)",
       R"(a.xml:4: error: <vehicle><body>: name="frame" is already the name of a body (line 3); names are unique in a file
)"},
      {5, R"(<suspension name="spring" element="primary" upper="fram" lower="axle" x="1 m"/>)",
       R"(a.xml:5: error: <vehicle><suspension>: upper="fram" names no part of this vehicle; a body is expected; did you mean "frame"?
)"},
      {3, R"(<body name="frame" mass="9 t" motion="z pitch"/>)",
       R"(a.xml:3: error: <vehicle><body>: pitches (motion names "pitch") without pitch_inertia; give it, e.g. pitch_inertia="70 t*m^2"
)"},
      {3, R"(<body name="frame" mass="9 t" motion="z"/>
  <body name="loose" mass="-9 t" motion="z"/>
  <wheelset name="w" x="1 mm/s"/>)",
       R"(a.xml:4: error: <vehicle><body>: mass="-9 t"; must be > 0
a.xml:4: error: <vehicle><body>: "loose" stands on nothing: no chain of springs leads from it down to a wheelset; add a <suspension> under it whose element has stiffness_z > 0
a.xml:5: error: <vehicle><wheelset>: x="1 mm/s" is a speed; a length is expected, e.g. "3.725 m"
a.xml:5: error: <vehicle><wheelset>: nothing stands on "w": no <suspension> names it as its lower; add the <suspension>, or remove the wheelset
)"},
  };
  for (const Spoilt& each : cases) {
    const auto outcome = readVehicleText(withLine(test::kVehicleLines, each.line, each.instead), "a.xml");
    EXPECT_EQ(outcome.problems.text(), each.says);
    EXPECT_FALSE(outcome.value.has_value()) << each.instead;
  }
}

}  // namespace
}  // namespace vehicle
