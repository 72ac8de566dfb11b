#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cli/program.h"
#include "tests/support/source_tree.h"

namespace vehicle::test {
namespace {

const std::vector<std::string> kCommands = {"check",    "info",    "simulate", "modes",
                                            "validate", "profile", "study",    "schema"};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(CommandLine, HelpOfEveryCommandGivesUsageExampleAndExitStatusOnStdout) {
  for (const std::string& command : kCommands) {
    const ProgramRun run = runVehicle({command, "--help"});
    EXPECT_EQ(run.status, 0) << command;
    EXPECT_EQ(run.out.rfind("usage: vehicle " + command, 0), 0u) << run.out;
    EXPECT_TRUE(has(run.out, "Example: vehicle " + command)) << command;
    EXPECT_TRUE(
        has(run.out, "Exit status: 0 done; 1 an input file is wrong; 2 this command line is wrong; 3 the run failed;"))
        << command;
    EXPECT_EQ(run.err, "") << command;
  }
}

TEST(CommandLine, HelpOfTheProgramNamesEveryCommand) {
  const ProgramRun run = runVehicle({"--help"});
  EXPECT_EQ(run.status, 0);
  for (const std::string& command : kCommands) EXPECT_TRUE(has(run.out, "\n  " + command + " ")) << command;
}

TEST(CommandLine, HelpOfSimulateTellsUnitsChoicesAndDefaults) {
  const std::string help = runVehicle({"simulate", "--help"}).out;
  for (const char* part : {"usage: vehicle simulate VEHICLE SCENARIO [options]",
                           "flat (carbody and two bogies by hand) | matrix (any vehicle, linear)",
                           "rk4 (fixed step) | dopri5 (adaptive step) | exact (matrix exponential)",
                           "\"80:10:160 km/h\"", "(default: from SCENARIO)",
                           "(default: \"1 ms\", or less as the fastest motion asks)", ".csv or .h5",
                           "--accuracy NUMBER"}) {
    EXPECT_TRUE(has(help, part)) << part << "\nis not in\n" << help;
  }
}

TEST(CommandLine, EveryOptionOfStudyTellsItsDefault) {
  const std::string help = runVehicle({"study", "--help"}).out;
  std::size_t options = 0;
  for (std::size_t at = help.find("\n  --"); at != std::string::npos; at = help.find("\n  --", at + 1)) {
    const std::string text = help.substr(at, std::min(help.find("\n  --", at + 1), help.find("\n\n", at)) - at);
    ++options;
    if (has(text, "--help") || has(text, "--quiet")) continue;
    EXPECT_TRUE(has(text, "(default: ") || has(text, "(required)")) << text;
  }
  EXPECT_EQ(options, 12u) << help;
}

TEST(CommandLine, VersionIsOneLineOnStdout) {
  const ProgramRun run = runVehicle({"--version"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, "vehicle " VEHICLE_VERSION "\n");
}

struct Wrong {
  std::vector<std::string> arguments;
  std::string message;
};

TEST(CommandLine, WhatIsWrongIsNamedBackOnStderrWithStatusTwo) {
  const std::string vehicle = model("vehicles/al-oraiqat-2017.xml");
  const std::string scenario = model("scenarios/paper-20mps.xml");
  const std::string suite = model("suites/paper.xml");
  const std::vector<Wrong> cases = {
      {{}, "vehicle: a command is missing; see vehicle --help\n"},
      {{"simulat"}, "vehicle: command \"simulat\" is unknown; did you mean \"simulate\"?\n"},
      {{"--verbose"}, "vehicle: option \"--verbose\" is unknown; "},
      {{"simulate", "--fomr", "flat", vehicle, scenario},
       "vehicle simulate: option \"--fomr\" is unknown; did you mean \"--form\"?\n"},
      {{"simulate", vehicle, scenario, "--fomr=flat"},
       "vehicle simulate: option \"--fomr\" is unknown; did you mean \"--form\"?\n"},
      {{"modes", vehicle, "--gravty", "9.81 m/s^2"},
       "vehicle modes: option \"--gravty\" is unknown; did you mean \"--gravity\"?\n"},
      {{"simulate", vehicle}, "vehicle simulate: SCENARIO is missing; "},
      {{"check"}, "vehicle check: FILE is missing; "},
      {{"simulate", vehicle, scenario, "extra"}, "vehicle simulate: \"extra\" is one argument too many; "},
      {{"simulate", vehicle, scenario, "--speed"}, "vehicle simulate: --speed needs a value; "},
      {{"simulate", vehicle, scenario, "--speed", "20 m"},
       "vehicle simulate: --speed: \"20 m\" is a length; a speed is expected, e.g. \"72 km/h\""},
      {{"simulate", vehicle, scenario, "--speed", "20"},
       "vehicle simulate: --speed: \"20\" has no unit; a speed is expected"},
      {{"simulate", vehicle, scenario, "--speed", "-3 m/s"},
       "vehicle simulate: --speed: \"-3 m/s\" must be finite and > 0"},
      {{"simulate", vehicle, scenario, "--step", "0 ms"}, "vehicle simulate: --step: \"0 ms\" must be finite and > 0"},
      {{"simulate", vehicle, scenario, "--form", "matrxi"},
       "vehicle simulate: --form: \"matrxi\" is unknown; did you mean \"matrix\"?"},
      {{"simulate", vehicle, scenario, "--method", "dopri"},
       "vehicle simulate: --method: \"dopri\" is unknown; did you mean \"dopri5\"?"},
      {{"simulate", vehicle, scenario, "--form", "mbs", "--method", "exact"},
       "vehicle: the method exact needs a linear form, and mbs is nonlinear; take dopri5, or the form mbs-linear\n"},
      {{"simulate", vehicle, scenario, "--output", "run.txt"},
       "vehicle: --output run.txt: extension \".txt\" is unknown; name it .csv (text) or .h5 (HDF5)\n"},
      {{"simulate", vehicle, scenario, "--output", "a.csv", "--output", "a.csv"},
       "vehicle: --output a.csv is given twice\n"},
      {{"modes", vehicle, "--form", "mbs"}, "vehicle: --form: modes need a linear form; mbs is nonlinear\n"},
      {{"info", vehicle, "--format", "jsn"}, "vehicle info: --format: \"jsn\" is unknown; did you mean \"json\"?"},
      {{"schema", "--xsd", "--markdown"},
       "vehicle schema: --xsd and --markdown exclude each other; give one of them\n"},
      {{"validate", vehicle}, "vehicle: SCENARIO is missing, or a suite instead of VEHICLE\n"},
      {{"validate", suite, scenario}, "vehicle: a suite names its scenarios itself; omit SCENARIO\n"},
  };
  for (const Wrong& wrong : cases) {
    const ProgramRun run = runVehicle(wrong.arguments);
    EXPECT_EQ(run.status, 2) << wrong.message;
    EXPECT_EQ(run.out, "") << wrong.message;
    EXPECT_EQ(run.err.rfind(wrong.message, 0), 0u) << "said:     " << run.err << "expected: " << wrong.message;
  }
}

TEST(CommandLine, BashCompletionKnowsEveryCommandAndEveryOptionOfItsHelp) {
  const std::string completion = textOf(sourcePath("apps/cli/completion/vehicle.bash"));
  ASSERT_NE(completion, "");
  for (const std::string& command : kCommands) {
    EXPECT_TRUE(has(completion, " " + command + " ") || has(completion, "\"" + command + " ") ||
                has(completion, command + "\""))
        << command;
    EXPECT_TRUE(has(completion, "      " + command + ") words=")) << command;
    const std::string help = runVehicle({command, "--help"}).out;
    for (std::size_t at = help.find("\n  --"); at != std::string::npos; at = help.find("\n  --", at + 1)) {
      const std::string option = help.substr(at + 3, help.find(' ', at + 3) - at - 3);
      EXPECT_TRUE(has(completion, option)) << command << " " << option;
    }
  }
}

/// What bash offers for the last word, one a line.
std::string completed(const TestFolder& folder, const std::string& words) {
  const std::string command = "cd '" + folder.root().string() + "' && bash -c 'source \"$0\"; COMP_WORDS=(" + words +
                              "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _vehicle; printf \"%s\\n\" " +
                              "\"${COMPREPLY[@]}\" | sort' '" + sourcePath("apps/cli/completion/vehicle.bash") + "' " +
                              ">offered 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  const std::string offered = textOf(folder.path("offered"));
  std::filesystem::remove(folder.path("offered"));
  return offered;
}

TEST(CommandLine, BashCompletionOffersStudiesAndAfterShowDatabases) {
  const TestFolder folder;
  for (const char* name : {"study.xml", "done.sqlite", "table.csv"}) static_cast<void>(folder.file(name, ""));
  EXPECT_EQ(completed(folder, "vehicle study \"\""), "show\nstudy.xml\n");
  EXPECT_EQ(completed(folder, "vehicle study show \"\""), "done.sqlite\n");
  EXPECT_EQ(completed(folder, "vehicle study show done.sqlite --wri"), "--write-best\n");
  EXPECT_EQ(completed(folder, "vehicle study study.xml --export t"), "table.csv\n");
  EXPECT_EQ(completed(folder, "vehicle study study.xml --output a.sqlite --over"), "--overwrite\n");
  EXPECT_EQ(completed(folder, "vehicle stu"), "study\n");
  EXPECT_EQ(completed(folder, "vehicle hel"), "help\n");
  EXPECT_EQ(completed(folder, "vehicle help si"), "simulate\n");
  EXPECT_EQ(completed(folder, "vehicle help simulate \"\""), "\n");
}

}  // namespace
}  // namespace vehicle::test
