#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cli/program.h"

// What only a command finds, beyond the reader's own checks: every problem has the file and line of the part it is about.
namespace vehicle::test {
namespace {

constexpr const char* kCoach = R"(<vehicle name="coach" format="1">
  <element name="spring" stiffness_z="1 MN/m"/>
  <body name="frame" mass="10 t" pitch_inertia="90 t*m^2" motion="z pitch"/>
  <wheelset name="w1" x="2 m"/>
  <wheelset name="w2" x="-2 m"/>
  <suspension name="p1" element="spring" upper="frame" lower="w1" x="2 m"/>
  <suspension name="p2" element="spring" upper="frame" lower="w2" x="-2 m"/>
</vehicle>
)";

constexpr const char* kTrack = R"(<scenario name="track" format="1">
  <run speed="20 m/s" duration="1 s" output_step="5 ms"/>
  <track history="extended">
    <harmonic name="wave" wavelength="25 m" amplitude="5 mm"/>
  </track>
  <initial_state from="zero"/>
</scenario>
)";

constexpr const char* kStudy = R"(<study name="study" format="1">
  <vehicle file="coach.xml"/>
  <scenario file="track.xml"/>
  <design name="heavy"> <set parameter="frame.mass" value="11 t"/> </design>
  <metric name="frame.az.rms"/>
</study>
)";

constexpr const char* kTrain = R"(<train name="train" format="1">
  <vehicle file="coach.xml" count="3" spacing="8 m"/>
</train>
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

struct Case {
  const char* file;  // whose text changes
  std::string from;
  std::string to;
  std::vector<std::string> command;  // names of files are those of the folder
  int status;
  const char* place;  // where the first problem is
};

void expectPlaces(const std::vector<Case>& cases) {
  static const std::regex kPlaced("^(.+?):([0-9]+): error: .+");
  for (const Case& each : cases) {
    const TestFolder folder;
    const auto write = [&](const std::string& name, const std::string& text) {
      folder.file(name, name == each.file && !each.from.empty() ? replaced(text, each.from, each.to) : text);
    };
    write("coach.xml", kCoach);
    write("track.xml", kTrack);
    write("on-rail.xml", replaced(kTrack, "from=\"zero\"", "from=\"on_rail\""));
    write("train.xml", kTrain);
    write("study.xml", kStudy);
    write("steady.xml", replaced(kStudy, "format=\"1\"", "format=\"1\" evaluation=\"steady_state\""));
    write("suite.xml",
          "<suite name=\"suite\" format=\"1\">\n  <vehicle file=\"coach.xml\"/>\n  <scenario "
          "file=\"track.xml\"/>\n</suite>\n");
    std::vector<std::string> command = each.command;
    for (std::string& word : command) {
      if (word.ends_with(".xml") || word.ends_with(".sqlite")) word = folder.path(word);
    }
    const ProgramRun run = runVehicle(command);
    const std::string said = run.out + run.err;
    EXPECT_EQ(run.status, each.status) << each.command[0] << " " << each.to << "\n" << said;
    bool any = false;
    for (std::size_t at = 0; at < said.size();) {
      const std::size_t end = std::min(said.find('\n', at), said.size());
      const std::string line = said.substr(at, end - at);
      at = end + 1;
      if (line.find("error: ") == std::string::npos) continue;
      std::smatch match;
      ASSERT_TRUE(std::regex_match(line, match, kPlaced)) << line;
      const std::string text = textOf(match[1].str());
      EXPECT_LE(std::stol(match[2].str()), std::count(text.begin(), text.end(), '\n')) << line;
      EXPECT_GE(std::stol(match[2].str()), 1) << line;
      if (!any) {
        EXPECT_NE(line.find('/' + std::string(each.place)), std::string::npos) << line;
      }
      any = true;
    }
    EXPECT_TRUE(any) << each.command[0] << " " << each.to << "\n" << said;
  }
}

TEST(ProblemPlaces, OfRunsAreFileAndLine) {
  const std::vector<std::string> simulate = {"simulate", "coach.xml", "track.xml"};
  const std::vector<Case> cases = {
      // statics
      {"coach.xml",
       R"(x="-2 m"/>
</vehicle>)",
       R"(x="-2 m" preload="10 kN"/>
</vehicle>)",
       {"info", "coach.xml"},
       1,
       "coach.xml:3"},
      {"coach.xml", R"(pitch_inertia="90 t*m^2" motion="z pitch")",
       R"(x="3 m" pitch_inertia="90 t*m^2" motion="z pitch")", simulate, 1, "coach.xml:5"},
      {"coach.xml",
       R"(<body name="frame" )",
       R"(<body name="frame" x="3 m" )",
       {"modes", "coach.xml"},
       1,
       "coach.xml:5"},
      {"coach.xml",
       R"(<body name="frame" )",
       R"(<body name="frame" x="3 m" )",
       {"check", "train.xml"},
       1,
       "coach.xml:5"},
      {"coach.xml",
       R"(<body name="frame" )",
       R"(<body name="frame" x="3 m" )",
       {"simulate", "train.xml", "track.xml"},
       1,
       "coach.xml:5"},
      {"coach.xml",
       R"(<body name="frame" )",
       R"(<body name="frame" x="3 m" )",
       {"validate", "coach.xml", "track.xml"},
       1,
       "coach.xml:5"},
      {"coach.xml",
       R"(<body name="frame" )",
       R"(<body name="frame" x="3 m" )",
       {"profile", "coach.xml", "track.xml", "--threads", "1"},
       1,
       "coach.xml:5"},
      // the scenario beside the vehicle
      {"track.xml", R"(<initial_state from="zero"/>)", R"(<initial_state><body name="car" z="1 mm"/></initial_state>)",
       simulate, 1, "track.xml:6"},
      {"track.xml",
       R"(<initial_state from="zero"/>)",
       R"(<initial_state><body name="w1" z="1 mm"/></initial_state>)",
       {"check", "coach.xml", "track.xml"},
       1,
       "track.xml:6"},
      {"track.xml", R"(<track history="extended">
    <harmonic name="wave" wavelength="25 m" amplitude="5 mm"/>
  </track>)",
       R"(<rig>
    <input wheelset="w9"><sine amplitude="1 mm" frequency="2 Hz"/></input>
  </rig>)",
       simulate, 1, "track.xml:4"},
      // the rail
      {"track.xml", R"(<harmonic name="wave" wavelength="25 m" amplitude="5 mm"/>)",
       R"(<bump shape="half_sine" height="1 mm" length="1e-12 m" start="3 m"/>)", simulate, 1, "track.xml:4"},
      {"track.xml",
       R"(duration="1 s")",
       R"(distance="20 m")",
       {"simulate", "coach.xml", "track.xml", "--speed", "10 km/s"},
       1,
       "track.xml:2"},
      // the state at t = 0: a body that pitches freely has no one rest on the rail
      {"coach.xml",
       R"(lower="w1" x="2 m"/>
  <suspension name="p2" element="spring" upper="frame" lower="w2" x="-2 m"/>)",
       R"(lower="w1" x="0 m"/>
  <suspension name="p2" element="spring" upper="frame" lower="w2" x="0 m"/>)",
       {"simulate", "coach.xml", "on-rail.xml"},
       1,
       "on-rail.xml:6"},
      // forms
      {"coach.xml", "", "", {"simulate", "coach.xml", "track.xml", "--form", "flat"}, 1, "coach.xml:"},
  };
  expectPlaces(cases);
}

TEST(ProblemPlaces, OfStudiesTrainsAndSuitesAreFileAndLine) {
  const std::vector<Case> cases = {
      // studies
      {"track.xml",
       R"(<harmonic name="wave" wavelength="25 m" amplitude="5 mm"/>)",
       R"(<dip shape="half_sine" depth="1 mm" length="2 m"/>)",
       {"study", "steady.xml", "--output", "a.sqlite"},
       1,
       "track.xml:1"},
      {"study.xml",
       R"(value="11 t")",
       R"(value="11 m")",
       {"study", "study.xml", "--output", "a.sqlite"},
       1,
       "study.xml:4"},
      {"study.xml", R"(frame.az.rms)", R"(frame.az.peek)", {"check", "study.xml"}, 1, "study.xml:5"},
      {"study.xml", R"(frame.az.rms)", R"(fram.az.rms)", {"check", "study.xml"}, 1, "study.xml:5"},
      {"coach.xml", R"(mass="10 t")", R"(mass="-10 t")", {"check", "study.xml"}, 1, "coach.xml:3"},
      // trains and suites
      {"train.xml", R"(count="3")", R"(count="0")", {"info", "train.xml"}, 1, "train.xml:2"},
      {"coach.xml", R"(mass="10 t")", R"(mass="10 m")", {"info", "train.xml"}, 1, "coach.xml:3"},
      {"suite.xml", R"(track.xml)", R"(trakc.xml)", {"validate", "suite.xml"}, 1, "suite.xml:3"},
      {"coach.xml", R"(mass="10 t")", R"(mass="10 m")", {"validate", "suite.xml"}, 1, "coach.xml:3"},
  };
  expectPlaces(cases);
}

}  // namespace
}  // namespace vehicle::test
