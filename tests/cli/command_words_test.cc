// Words that every command line may have: help, version, -q, and options that are given twice.
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cli/help_pages.h"
#include "tests/cli/studies.h"

namespace vehicle::test {
namespace {

/// A value that an option takes.
std::string valueFor(const std::string& option, const std::string& type) {
  static const std::map<std::string, std::string> by_option = {
      {"--format", "csv"}, {"--form", "matrix"},  {"--method", "rk4"},   {"--scheme", "serial"},
      {"--map", "auto"},   {"--waiting", "spin"}, {"--pinning", "free"}, {"--priority", "fifo"}};
  static const std::map<std::string, std::string> by_type = {
      {"N", "2"},         {"SPEED", "1 m/s"},          {"SPEEDS", "1 m/s"}, {"TIME", "1 ms"},
      {"NUMBER", "1e-6"}, {"ACCELERATION", "1 m/s^2"}, {"FILE", "a.csv"},   {"FOLDER", "best"}};
  const auto own = by_option.find(option);
  return own != by_option.end() ? own->second : by_type.at(type);
}

TEST(CommandWords, OptionsGivenTwiceAreCalledRepeated) {
  const std::set<std::string> lists = {"simulate --output", "validate --form", "validate --method"};
  for (const std::string& command : commands()) {
    for (const auto& [option, type] : optionsOf(command)) {
      if (option == "--help" || option == "--set" || lists.contains(command + ' ' + option)) continue;
      std::vector<std::string> words = {command};
      for (int time = 0; time < 2; ++time) {
        words.push_back(option);
        if (!type.empty()) words.push_back(valueFor(option, type));
      }
      const ProgramRun run = runVehicle(words);
      EXPECT_EQ(run.status, 2) << command << ' ' << option;
      EXPECT_EQ(run.err, "vehicle " + command + ": " + option + " is given 2 times; give it once\n");
    }
  }
  const TestFolder folder;
  static_cast<void>(smallStudyIn(folder));
  for (const std::string option : {"--form", "--method"}) {
    const std::string name = option == "--form" ? "matrix" : "rk4";
    const ProgramRun run =
        runVehicle({"validate", folder.path("v.xml"), folder.path("s.xml"), option, name, option, name});
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err, "vehicle: " + option + " " + name + " is given twice\n");
  }
}

TEST(CommandWords, ForHelpWorkAnywhereOnTheLine) {
  const std::string program = runVehicle({"--help"}).out;
  ASSERT_TRUE(program.starts_with("usage: vehicle COMMAND")) << program;
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"-h"}, {"help"}, {"help", "help"}, {"-q", "-h"}, {"help", "--help"}}) {
    const ProgramRun run = runVehicle(words);
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.out, program) << words[0];
  }
  for (const std::string& command : commands()) {
    const std::string page = runVehicle({command, "--help"}).out;
    ASSERT_TRUE(page.starts_with("usage: vehicle " + command)) << page;
    std::vector<std::vector<std::string>> lines = {{"help", command}, {command, "none.xml", "--unknown", "-h"}};
    if (command == "simulate") {
      lines.insert(lines.end(), {{command, "help"},
                                 {"-h", command},
                                 {"--help", command, "none.xml"},
                                 {"--format", "csv", "help", command},
                                 {command, "--speed", "none", "--help"}});
    }
    for (const std::vector<std::string>& words : lines) {
      const ProgramRun run = runVehicle(words);
      EXPECT_EQ(run.status, 0) << words[0] << ' ' << words[1] << run.err;
      EXPECT_EQ(run.out, page) << words[0] << ' ' << words[1];
    }
  }
  const ProgramRun unknown = runVehicle({"help", "simulat"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_EQ(unknown.err, "vehicle: command \"simulat\" is unknown; did you mean \"simulate\"?\n");
}

TEST(CommandWords, VersionAndQuietWorkAnywhereOnTheLine) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"--version"}, {"simulate", "--version"}, {"check", "none.xml", "--version"}, {"-q", "--version"}}) {
    const ProgramRun run = runVehicle(words);
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.out, "vehicle " VEHICLE_VERSION "\n") << words[0];
  }
  const TestFolder folder;
  static_cast<void>(smallStudyIn(folder));
  const std::string v = folder.path("v.xml"), s = folder.path("s.xml"), to = folder.path("to.csv");
  for (std::vector<std::string> words :
       std::vector<std::vector<std::string>>{{"-q", "simulate", v, s},
                                             {"--quiet", "simulate", v, s},
                                             {"simulate", "-q", v, s},
                                             {"simulate", v, s, "-q"},
                                             {"--format", "table", "-q", "--strict", "simulate", v, s}}) {
    words.insert(words.end(), {"--output", to});
    const ProgramRun run = runVehicle(words);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "") << words[0] << ' ' << words[1];
    EXPECT_TRUE(has(run.out, "carbody.z")) << run.out;
  }
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{}, {"-q"}, {"--format", "csv"}}) {
    EXPECT_EQ(runVehicle(words).err, "vehicle: a command is missing; see vehicle --help\n");
  }
}

}  // namespace
}  // namespace vehicle::test
