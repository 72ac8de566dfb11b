// No option without effect in silence: every option of every command beside what makes it meaningless. A new option
// needs a row in one of the tables here: they are held against the pages of --help.
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cli/help_pages.h"
#include "tests/cli/studies.h"

namespace vehicle::test {
namespace {

/// The small vehicle over a short track and on a rig, with heights, a suite and studies of several kinds.
class Files {
 public:
  Files() {
    static_cast<void>(smallStudyIn(folder_));
    folder_.file("rig.xml", R"(<scenario name="shaker" format="1">
  <run duration="1 s" output_step="5 ms"/>
  <rig><input wheelset="wheelset"><sine amplitude="1 mm" angular_frequency="6 rad/s"/></input></rig>
</scenario>
)");
    folder_.file("suite.xml", R"(<suite name="one" format="1">
  <vehicle file="v.xml"/> <scenario file="s.xml"/> <form name="matrix"/> <form name="mbs-linear"/>
</suite>
)");
    const std::string aimless = with(smallStudy(), R"(  <objective metric="carbody.az.rms" goal="minimise"/>)", "");
    folder_.file("aimless.xml", aimless);
    std::string nameless =
        with(aimless, R"(<design name="soft"><set parameter="spring.stiffness_z" value="0.5 MN/m"/></design>)",
             R"(<vary parameter="spring.damping_z" values="1 kN*s/m, 2 kN*s/m"/>)");
    nameless =
        with(nameless, R"(<design name="damped"><set parameter="spring.damping_z" value="40 kN*s/m"/></design>)", "");
    folder_.file("nameless.xml", nameless);
  }
  /// Words with a dot, blanks aside, are files of the folder; models/ are shipped ones.
  [[nodiscard]] std::vector<std::string> words(const std::vector<std::string>& given) const {
    std::vector<std::string> all;
    for (const std::string& word : given) {
      const bool is_file = word.find(".xml") != std::string::npos || word.find(".sqlite") != std::string::npos;
      all.push_back(!is_file ? word : word.starts_with("models/") ? model(word.substr(7)) : folder_.path(word));
    }
    return all;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }

 private:
  TestFolder folder_;
};

struct Useless {
  std::string option;              // that has no effect; first in its line
  std::vector<std::string> words;  // of the whole command
  std::string why;                 // a part of the message
};

// Files without effect on an option come first, so that a row reads as a command line.
const std::vector<Useless>& useless() {
  static const std::string paper = "models/vehicles/al-oraiqat-2017.xml";
  static const std::string track = "models/scenarios/paper-20mps.xml";
  static const std::vector<Useless> rows = {
      {"--step", {"simulate", "v.xml", "s.xml", "--step", "1 ms"}, "the method is exact, by default"},
      {"--step", {"simulate", "v.xml", "s.xml", "--method", "dopri5", "--step", "1 ms"}, "take --method rk4"},
      {"--step", {"simulate", "v.xml", "s.xml", "--form", "mbs", "--step", "1 ms"}, "the method is dopri5, by default"},
      {"--rtol", {"simulate", "v.xml", "s.xml", "--rtol", "1e-6"}, "only dopri5 has tolerances"},
      {"--rtol", {"simulate", "v.xml", "s.xml", "--method", "rk4", "--rtol", "1e-6"}, "the method is rk4"},
      {"--atol", {"simulate", "v.xml", "s.xml", "--method", "exact", "--atol", "1e-6"}, "take --method dopri5"},
      {"--accuracy", {"simulate", "v.xml", "s.xml", "--accuracy", "1e-6"}, "only simbody_rkm"},
      {"--accuracy", {"simulate", "v.xml", "s.xml", "--form", "mbs", "--accuracy", "1e-6"}, "the method is dopri5"},
      {"--speed", {"simulate", "v.xml", "rig.xml", "--speed", "20 m/s"}, "is a rig with a duration"},
      {"--map auto", {"simulate", "v.xml", "s.xml", "--map", "auto"}, "one thread"},
      {"--map body",
       {"simulate", paper, track, "--method", "rk4", "--threads", "auto", "--scheme", "serial", "--map", "body"},
       "take --threads 2 with another scheme"},
      {"--map paper",
       {"simulate", paper, track, "--method", "rk4", "--threads", "2", "--scheme", "pipeline", "--map", "paper"},
       "no equations of their own"},
      {"--map body",
       {"simulate", paper, track, "--method", "rk4_split", "--threads", "2", "--map", "body"},
       "no equations of their own"},
      {"--scheme stages", {"simulate", paper, track, "--method", "rk4", "--scheme", "stages"}, "add --threads 2"},
      {"--overwrite", {"simulate", "v.xml", "s.xml", "--overwrite"}, "add --output"},
      {"--step", {"validate", "v.xml", "s.xml", "--method", "dopri5", "--step", "1 ms"}, "run here are dopri5, exact"},
      {"--step", {"validate", "v.xml", "s.xml", "--form", "matrix", "--method", "exact", "--step", "1 ms"}, "rk4"},
      {"--rtol", {"validate", "v.xml", "s.xml", "--method", "rk4", "--rtol", "1e-6"}, "run here are exact, rk4"},
      {"--atol", {"validate", "v.xml", "s.xml", "--method", "exact", "--form", "matrix", "--atol", "1e-6"}, "dopri5"},
      {"--accuracy", {"validate", "v.xml", "s.xml", "--form", "matrix", "--accuracy", "1e-6"}, "simbody_rkm"},
      {"--accuracy", {"validate", "suite.xml", "--method", "rk4", "--accuracy", "1e-6"}, "run here are exact, rk4"},
      {"--serial", {"validate", "v.xml", "s.xml", "--serial"}, "none of these runs is shared"},
      {"--serial", {"validate", paper, track, "--method", "dopri5", "--serial"}, "none of these runs is shared"},
      {"--serial", {"validate", paper, track, "--form", "matrix", "--serial"}, "none of these runs is shared"},
      {"--time-limit", {"validate", "v.xml", "s.xml", "--time-limit", "3 s"}, "none of these runs is shared"},
      {"--time-limit", {"validate", paper, track, "--serial", "--time-limit", "3 s"}, "--serial omits the runs"},
      {"--allow-unjudged", {"validate", "v.xml", "s.xml", "--allow-unjudged"}, "none of these runs is shared"},
      {"--allow-unjudged", {"validate", paper, track, "--serial", "--allow-unjudged"}, "--serial omits the runs"},
      {"--details", {"validate", "v.xml", "s.xml", "--format", "csv", "--details"}, "csv and json hold every detail"},
      {"--details", {"validate", "v.xml", "s.xml", "--format", "json", "--details"}, "csv and json hold every detail"},
      {"--details", {"validate", "suite.xml", "--details"}, "a suite prints one line for each case"},
      {"--speed", {"validate", "v.xml", "rig.xml", "--speed", "20 m/s"}, "is a rig with a duration"},
      {"--gravity", {"modes", "v.xml", "--gravity", "1.62 m/s^2"}, "no static load at a height"},
      {"--gravity", {"modes", paper, "--form", "flat-literal", "--gravity", "1.62 m/s^2"}, "do not depend on gravity"},
      {"--threads", {"profile", paper, track, "--realtime", "1 ms", "--threads", "2"}, "one thread computes all"},
      {"--scheme", {"profile", paper, track, "--realtime", "1 ms", "--scheme", "halo"}, "one thread computes all"},
      {"--map", {"profile", paper, track, "--realtime", "1 ms", "--map", "body"}, "one thread computes all"},
      {"--waiting", {"profile", paper, track, "--realtime", "1 ms", "--waiting", "spin"}, "one thread computes all"},
      {"--method", {"profile", paper, track, "--realtime", "1 ms", "--method", "rk4"}, "the method is rk4"},
      {"--step", {"profile", paper, track, "--realtime", "1 ms", "--step", "1 ms"}, "the period is the step"},
      {"--every", {"profile", paper, track, "--realtime", "1 ms", "--every", "2"}, "no step is traced"},
      {"--trace", {"profile", paper, track, "--realtime", "1 ms", "--trace", "t.json"}, "no step is traced"},
      {"--timeline", {"profile", paper, track, "--realtime", "1 ms", "--timeline", "t.svg"}, "no step is traced"},
      {"--speed", {"profile", "v.xml", "rig.xml", "--realtime", "1 ms", "--speed", "20 m/s"}, "is a rig"},
      {"--speed", {"profile", "v.xml", "rig.xml", "--threads", "1", "--speed", "20 m/s"}, "is a rig"},
      {"--waiting", {"profile", paper, track, "--threads", "1", "--waiting", "spin"}, "the run has one thread"},
      {"--pinning", {"profile", paper, track, "--threads", "1", "--pinning", "free"}, "the run has one thread"},
      {"--priority", {"profile", paper, track, "--threads", "1", "--priority", "raised"}, "the run has one thread"},
      {"--every", {"profile", paper, track, "--threads", "1", "--every", "4"}, "the run has one thread"},
      {"--map body", {"profile", paper, track, "--threads", "1", "--map", "body"}, "the run has one thread"},
      {"--scheme halo", {"profile", paper, track, "--threads", "1", "--scheme", "halo"}, "the run has one thread"},
      {"--step", {"profile", paper, track, "--method", "exact", "--step", "1 ms"}, "the method is exact"},
      {"--overwrite", {"profile", paper, track, "--overwrite"}, "add --trace or --timeline"},
      {"--best", {"study", "aimless.xml", "--output", "a.sqlite", "--best", "3"}, "has no <objective>"},
      {"--write-best",
       {"study", "nameless.xml", "--output", "a.sqlite", "--write-best", "best"},
       "neither an <objective>"},
      {"--overwrite", {"study", "study.xml", "--output", "a.sqlite", "--resume", "--overwrite"}, "add --export"},
      {"--output", {"study", "show", "a.sqlite", "--output", "b.sqlite"}, "study show evaluates nothing"},
      {"--resume", {"study", "show", "a.sqlite", "--resume"}, "study show evaluates nothing"},
      {"--jobs", {"study", "show", "a.sqlite", "--jobs", "2"}, "study show evaluates nothing"},
      {"--set", {"study", "show", "a.sqlite", "--set", "spring.damping_z=30 kN*s/m"}, "study show evaluates nothing"},
      {"--overwrite", {"study", "show", "a.sqlite", "--overwrite"}, "add --export or --write-best"},
  };
  return rows;
}

// What a command reads whatever stands beside it; beside some options they are wrong, with a message of their own.
const std::map<std::string, std::set<std::string>>& alwaysRead() {
  static const std::map<std::string, std::set<std::string>> options = {
      {"check", {"--set"}},
      {"info", {"--gravity", "--set"}},
      {"simulate", {"--form", "--method", "--threads", "--output", "--set"}},
      {"modes", {"--form", "--set"}},
      {"validate", {"--form", "--method", "--set"}},
      {"profile", {"--form", "--realtime", "--set"}},
      {"study", {"--export"}},
      {"schema", {"--xsd", "--markdown"}},
  };
  return options;
}

TEST(Options, OfEveryCommandStandInTheTablesOfThisTest) {
  const std::set<std::string> common = {"--format", "--quiet", "--strict", "--help"};
  for (const std::string& command : commands()) {
    std::set<std::string> known = alwaysRead().at(command);
    for (const Useless& row : useless()) {
      if (row.words[0] == command) known.insert(row.option.substr(0, row.option.find(' ')));
    }
    for (const auto& [option, value] : optionsOf(command)) {
      EXPECT_TRUE(known.contains(option) || common.contains(option)) << "vehicle " << command << ' ' << option;
    }
  }
}

TEST(Options, WithoutEffectAreRefusedWithTheReasonAndWhatToDo) {
  const Files files;
  for (const Useless& row : useless()) {
    const ProgramRun run = runVehicle(files.words(row.words));
    std::string line;
    for (const std::string& word : row.words) line += word + ' ';
    EXPECT_EQ(run.status, 2) << line << run.err;
    EXPECT_EQ(run.out, "") << line;
    EXPECT_EQ(linesOf(run.err).size(), 1u) << line << run.err;
    EXPECT_TRUE(run.err.starts_with("vehicle: " + row.option + " has no effect")) << line << run.err;
    EXPECT_TRUE(has(run.err, row.why)) << line << run.err;
    EXPECT_TRUE(has(run.err, "omit ") || has(run.err, "; add ")) << line << run.err;
  }
}

TEST(Options, ThatAreReadAreTaken) {
  const Files files;
  const std::vector<std::vector<std::string>> lines = {
      {"simulate", "v.xml", "s.xml", "--method", "rk4", "--step", "2 ms", "--speed", "10 m/s", "--threads", "1"},
      {"simulate", "v.xml", "s.xml", "--method", "dopri5", "--rtol", "1e-6", "--atol", "1e-8"},
      {"simulate", "v.xml", "s.xml", "--form", "mbs", "--method", "simbody_rkm", "--accuracy", "1e-6"},
      {"simulate", "v.xml", "rig.xml", "--scheme", "serial"},
      {"validate", "v.xml", "s.xml", "--form", "matrix", "--step", "5 ms", "--rtol", "1e-8", "--atol", "1e-10"},
      {"validate", "suite.xml", "--accuracy", "1e-9", "--speed", "10 m/s"},
      {"info", "v.xml", "--gravity", "1.62 m/s^2"},
      {"study", "study.xml", "--output", "a.sqlite", "--best", "2", "--jobs", "1", "--resume"},
  };
  for (const std::vector<std::string>& line : lines) {
    const ProgramRun run = runVehicle(files.words(line));
    EXPECT_EQ(run.status, 0) << line[0] << ' ' << line[1] << ": " << run.err;
  }
}

}  // namespace
}  // namespace vehicle::test
