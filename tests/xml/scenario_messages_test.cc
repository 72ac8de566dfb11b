#include "libvehicle/xml/reader.h"

#include <gtest/gtest.h>

#include "tests/xml/files.h"

namespace vehicle {
namespace {

using test::Spoilt;
using test::withLine;

TEST(ScenarioReader, EveryWrongLineOfATrackIsTold) {
  const std::vector<Spoilt> cases = {
      {2, R"(<run speed="20 kg" duration="10 s"/>)",
       R"(a.xml:2: error: <scenario><run>: speed="20 kg" is a mass; a speed is expected, e.g. "72 km/h"
)"},
      {2, R"(<run speed="20 m/s" duration="10 s" output_step="0 s"/>)",
       R"(a.xml:2: error: <scenario><run>: output_step="0 s"; must be > 0
)"},
      {2, R"()",
       R"(a.xml:1: error: <scenario>: element <run> is missing; write e.g. <run speed="20 m/s" duration="10 s" output_step="5 ms"/>
)"},
      {2, R"(<run speed="20 m/s" duration="10 s"/>
  <run speed="20 m/s" duration="10 s"/>)",
       R"(a.xml:3: error: <scenario>: <run> stands a second time, first in line 2; remove one of them
)"},
      {2, R"(<run speed="20 m/s"/>)",
       R"(a.xml:2: error: <scenario><run>: has no duration and no distance; give one of them, e.g. duration="10 s"
)"},
      {2, R"(<run speed="20 m/s" duration="1 s" distance="1 m"/>)",
       R"(a.xml:2: error: <scenario><run>: has duration and distance; give one of them
)"},
      {3, R"(<track>)",
       R"(a.xml:3: error: <scenario><track>: attribute "history" is missing; write e.g. history="onset"
)"},
      {3, R"(<track history="onse">)",
       R"(a.xml:3: error: <scenario><track>: history="onse" is none of "onset", "extended"; did you mean "onset"?
)"},
      {3, R"(<track history="forever">)",
       R"(a.xml:3: error: <scenario><track>: history="forever" is none of "onset", "extended"; write one of these
)"},
      {4, R"(<harmonic wavelength="0 m" amplitude="5 mm" phase="5 mm" order="3 m"/>)",
       R"(a.xml:4: error: <scenario><track><harmonic>: wavelength="0 m"; must be > 0
a.xml:4: error: <scenario><track><harmonic>: phase="5 mm" is a length; an angle is expected, e.g. "1.2 mrad"
a.xml:4: error: <scenario><track><harmonic>: order="3 m" is a length; a plain number is expected, e.g. "3"
)"},
      {4, R"(<harmonic wavelength="25 m"/>)",
       R"(a.xml:4: error: <scenario><track><harmonic>: attribute "amplitude" is missing; write e.g. amplitude="2 mm"
)"},
      {4, R"(<harmonic wavelength="25 m" amplitude="5 mm" rail="lef"/>)",
       R"(a.xml:4: error: <scenario><track><harmonic>: rail="lef" is none of "both", "left", "right"; did you mean "left"?
)"},
      {4, R"(<dip shape="half-sine" depth="5 mm" length="2 m"/>)",
       R"(a.xml:4: error: <scenario><track><dip>: shape="half-sine" is none of "one_minus_cosine", "half_sine"; did you mean "half_sine"?
)"},
      {4, R"(<ramp rise="5 mm" length="0 m"/>)",
       R"(a.xml:4: error: <scenario><track><ramp>: length="0 m"; must be > 0
)"},
      {4, R"(<irregularity spectrum="erri-b176-low"/>)",
       R"(a.xml:4: error: <scenario><track>: element <irregularity> is unknown; what may stand here: <harmonic>, <dip>, <bump>, <ramp>
)"},
      {5, R"(</track>
  <initial_state from="rest"><body name="carbody" z="1 rad"/></initial_state>)",
       R"(a.xml:6: error: <scenario><initial_state>: from="rest" is none of "zero", "on_rail", "periodic"; write one of these
a.xml:6: error: <scenario><initial_state><body>: z="1 rad" is an angle; a length is expected, e.g. "3.725 m"
)"},
      {1, R"(<scenario name="s" format="1" gravity="-9.81 m/s^2">)",
       R"(a.xml:1: error: <scenario>: gravity="-9.81 m/s^2"; must be >= 0
)"},
  };
  for (const Spoilt& each : cases) {
    const auto outcome = readScenarioText(withLine(test::kScenarioLines, each.line, each.instead), "a.xml");
    EXPECT_EQ(outcome.problems.text(), each.says);
    EXPECT_FALSE(outcome.value.has_value()) << each.instead;
  }
}

TEST(ScenarioReader, EveryWrongLineOfARigIsTold) {
  const std::vector<Spoilt> cases = {
      {4, R"(<input><sine amplitude="6 mm" angular_frequency="5 Hz"/></input>)",
       R"(a.xml:4: error: <scenario><rig><input>: attribute "wheelset" is missing; write e.g. wheelset="wheelset_1"
a.xml:4: error: <scenario><rig><input><sine>: angular_frequency="5 Hz" is a frequency; an angular velocity is expected, e.g. "5.03 rad/s"
)"},
      {4, R"(<input wheelset="axle"><sin amplitude="6 mm" angular_frequency="-5 rad/s"/></input>)",
       R"(a.xml:4: error: <scenario><rig><input>: element <sin> is unknown; did you mean <sine>?
a.xml:4: error: <scenario><rig><input><sine>: angular_frequency="-5 rad/s"; must be > 0
)"},
      {4, R"(<input wheelset="axle">6 mm</input>)",
       R"(a.xml:4: error: <scenario><rig><input>: the text "6 mm" stands here; values are attributes; only <title> and <source> hold text
a.xml:4: error: <scenario><rig><input>: has no <sine>; add one, or remove the input: a wheelset without input stays at 0
)"},
  };
  for (const Spoilt& each : cases) {
    const auto outcome = readScenarioText(withLine(test::kRigLines, each.line, each.instead), "a.xml");
    EXPECT_EQ(outcome.problems.text(), each.says);
    EXPECT_FALSE(outcome.value.has_value()) << each.instead;
  }
}

TEST(SuiteReader, EveryWrongLineIsTold) {
  const std::vector<Spoilt> cases = {
      {2, R"(<vehicle/>)",
       R"(a.xml:2: error: <suite><vehicle>: attribute "file" is missing; write e.g. file="../vehicles/coach.xml"
)"},
      {2, R"(<vehicle file=" "/>)",
       R"(a.xml:2: error: <suite><vehicle>: file=" " names no file; write the path of one, counted from the folder of this file
)"},
      {4, R"(<speed from="20 km/h" to="150 km/h"/>)",
       R"(a.xml:4: error: <suite><speed>: attribute "count" is missing; write e.g. count="14"
)"},
      {4, R"(<speed value="20 m/s" from="20 m/s"/>)",
       R"(a.xml:4: error: <suite><speed>: "value" and "from" are both given, and value stands for from, to, count; remove one of them
)"},
      {4, R"(<speed value="20 m"/>)",
       R"(a.xml:4: error: <suite><speed>: value="20 m" is a length; a speed is expected, e.g. "72 km/h"
)"},
      {4, R"(<speed from="20 km/h" to="150 km/h" count="0"/>)",
       R"(a.xml:4: error: <suite><speed>: count="0"; must be from 1 to 10000
)"},
      {4, R"(<speed/>)",
       R"(a.xml:4: error: <suite><speed>: attribute "from" is missing; write e.g. from="20 km/h"
a.xml:4: error: <suite><speed>: attribute "to" is missing; write e.g. to="150 km/h"
a.xml:4: error: <suite><speed>: attribute "count" is missing; write e.g. count="14"
)"},
      {5, R"(<form name="flat 7"/>)",
       R"(a.xml:5: error: <suite><form>: name="flat 7" is no name; names have up to 64 letters a-z, A-Z, digits, "_" and "-", and begin with a letter or digit
)"},
      {5, R"(<from name="flat"/>)",
       R"(a.xml:5: error: <suite>: element <from> is unknown; did you mean <form>?
)"},
  };
  for (const Spoilt& each : cases) {
    const auto outcome = readSuiteText(withLine(test::kSuiteLines, each.line, each.instead), "a.xml");
    EXPECT_EQ(outcome.problems.text(), each.says);
    EXPECT_FALSE(outcome.value.has_value()) << each.instead;
  }
}

}  // namespace
}  // namespace vehicle
