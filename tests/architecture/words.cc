#include "tests/architecture/words.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace vehicle::test {

namespace fs = std::filesystem;

namespace {

struct Word {
  const char* pattern;  // ECMAScript
  const char* instead;
};

// Written apart, so that this file does not contain what it looks for.
constexpr std::array kWords = {
    Word{"[Mm]is"
         "fit",
         "unsupported, reason"},
    Word{"\\b[Kk]in"
         "k|[a-z]Kin"
         "k",
         "breakpoint (of a track: discontinuity)"},
    Word{"\\bStret"
         "ch(es)?\\b|\\bstret"
         "ch(es)?\\b",
         "interval"},
    Word{"\\bLot"
         "s\\b",
         "DisjointSets"},
    Word{"\\bSweepClo"
         "ck\\b",
         "PhasorTable"},
    Word{"\\b(letG"
         "o|sayBy"
         "e|tellFailu"
         "re)\\b",
         "release, sendShutdown, sendFailure"},
    Word{"takeTheLong"
         "Way",
         "useReferencePath"},
    Word{"\\b(Gather"
         "er|PassingFold"
         "er)\\b",
         "ProblemCollector, TemporaryDirectory"},
    Word{"\\bPUBLIC"
         "LY\\b|\\bPRIVATE"
         "LY\\b",
         "PUBLIC, PRIVATE"},
    Word{"\\b(StageSea"
         "t|WayProb"
         "lem|Choosin"
         "g)\\b",
         "MemberContext, TuningProblem, Tuner"},
    Word{"\\b(by tur"
         "ns|in tur"
         "ns)\\b",
         "alternately"},
    Word{"\\bfor who wan"
         "ts\\b|\\bfor eye"
         "s\\b",
         "for callers that need, for people"},
    Word{"\\bmen"
         "d it\\b|\\bmend"
         "ed\\b",
         "fix it, corrected"},
    Word{"leave the [a-z]+ awa"
         "y",
         "omit it"},
};

std::vector<fs::path> readFiles(const fs::path& root) {
  std::vector<fs::path> files{root / "README.md"};
  for (const char* folder : {"libvehicle", "apps", "tests", "benchmarks", "docs"}) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string kind = entry.path().extension().string();
      const bool is_read = kind == ".cc" || kind == ".h" || kind == ".inc" || kind == ".md" || kind == ".cmake" ||
                           entry.path().filename() == "CMakeLists.txt";
      if (entry.is_regular_file() && is_read) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

Violations privateWords(const fs::path& root) {
  std::vector<std::pair<std::regex, const char*>> words;
  for (const Word& each : kWords) words.emplace_back(std::regex(each.pattern), each.instead);
  Violations found;
  for (const fs::path& file : readFiles(root)) {
    std::ifstream stream(file);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
      ++number;
      std::smatch match;
      for (const auto& [pattern, instead] : words) {
        if (!std::regex_search(line, match, pattern)) continue;
        found.push_back(fs::relative(file, root).generic_string() + ":" + std::to_string(number) + ": \"" +
                        match.str() + "\"; say " + instead);
      }
    }
  }
  return found;
}

}  // namespace vehicle::test
