// README.md and the pages under docs/ against the program: the options that they use, the tables that they show.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cli/program.h"
#include "tests/support/source_tree.h"

namespace vehicle::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> pages() {
  const fs::path root = sourcePath();
  std::vector<std::string> files{(root / "README.md").string()};
  for (const auto& entry : fs::recursive_directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

struct Example {
  std::string place;  // "README.md:12"
  std::vector<std::string> words;
};

/// Lines of pages that call the program, each with the lines that a backslash ties to it.
std::vector<Example> examples() {
  std::vector<Example> found;
  for (const std::string& page : pages()) {
    std::ifstream stream(page);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
      ++number;
      for (std::string more; line.ends_with('\\') && std::getline(stream, more); ++number) {
        line.back() = ' ';
        line += more;
      }
      std::istringstream text(line);
      std::vector<std::string> words;
      for (std::string word; text >> word && word != "#" && word != ">";) words.push_back(word);
      auto program = words.begin();
      if (!words.empty() && (words[0] == "mpirun" || words[0] == "srun")) {
        program = std::find_if(words.begin(), words.end(), [](const std::string& word) {
          return word == "vehicle" || word.ends_with("/vehicle");
        });
      }
      const bool called = words.end() - program >= 2 && (*program == "vehicle" || program->ends_with("/vehicle"));
      if (called) found.push_back({page + ":" + std::to_string(number), {program + 1, words.end()}});
    }
  }
  return found;
}

TEST(PagesOfTheProgram, UseOptionsThatItHas) {
  std::map<std::string, std::string> help;  // of each command
  std::istringstream overview(runVehicle({"--help"}).out);
  for (std::string line; std::getline(overview, line);) {
    std::istringstream words(line);
    std::string command;
    if (line.starts_with("  ") && line[2] != '-' && line[2] != ' ' && words >> command) {
      help[command] = runVehicle({command, "--help"}).out;
    }
  }
  ASSERT_TRUE(help.contains("study"));
  std::size_t options = 0;
  for (const Example& example : examples()) {
    const auto command = help.find(example.words[0]);
    if (command == help.end()) continue;  // a table that begins with the vehicle
    for (const std::string& word : example.words) {
      if (!word.starts_with("--")) continue;
      ++options;
      EXPECT_NE(command->second.find("\n  " + word + " "), std::string::npos)
          << example.place << ": " << word << " is no option of vehicle " << command->first;
    }
  }
  EXPECT_GE(options, 20u);
}

// The closed form of a matrix, printed to five digits: no machine rounds it another way.
TEST(PagesOfTheProgram, ShowTheComparisonThatTheStudyPrints) {
  const TestFolder folder;
  const ProgramRun run =
      runVehicle({"study", model("studies/secondary-suspensions.xml"), "--output", folder.path("a.sqlite")});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::size_t begin = run.out.find("comparison\n");
  ASSERT_NE(begin, std::string::npos) << run.out;
  const std::string comparison = run.out.substr(begin, run.out.find("\n\n", begin) - begin);
  EXPECT_GE(std::count(comparison.begin(), comparison.end(), '\n'), 10) << comparison;
  for (const std::string page : {"docs/how-to/compare-designs.md"}) {
    EXPECT_NE(textOf(sourcePath(page)).find(comparison), std::string::npos)
        << page << " does not show this:\n" << comparison;
  }
}

}  // namespace
}  // namespace vehicle::test
