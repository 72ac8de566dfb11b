// What every command prints is as wide as the page, and nothing of it is lost there.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cli/help_pages.h"
#include "tests/cli/output_table.h"

namespace vehicle::test {
namespace {

using Words = std::vector<std::string>;

/// Bytes that begin a letter.
std::size_t lettersIn(const std::string& line) {
  return static_cast<std::size_t>(
      std::count_if(line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// What stands between blanks; names are parted behind their dots, where a header may be broken.
std::map<std::string, int> partsOf(const std::string& text) {
  std::map<std::string, int> parts;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    for (std::size_t begin = 0; begin < word.size();) {
      const std::size_t dot = word.find('.', begin);
      const std::size_t end = dot == std::string::npos ? word.size() : dot + 1;
      ++parts[word.substr(begin, end - begin)];
      begin = end;
    }
  }
  return parts;
}

/// A command whose table is looked at; its figures repeat from run to run unless it measures times.
struct Printed {
  const char* name;
  Words words;
  bool repeats;
};

class PageWidth : public testing::Test {
 protected:
  PageWidth() {
    files_.file("suite.xml",
                "<suite name=\"small\" format=\"1\"><vehicle file=\"v.xml\"/><scenario file=\"short.xml\"/>"
                "</suite>");
    static_cast<void>(
        runVehicle({"study", model("studies/secondary-suspensions.xml"), "--output", path("named.sqlite")}));
    static_cast<void>(
        runVehicle({"study", model("studies/stiffness-and-damping.xml"), "--output", path("sweep.sqlite")}));
  }
  [[nodiscard]] std::string path(const std::string& name) const { return files_.path(name); }

  [[nodiscard]] std::vector<Printed> commands() const {
    const std::string coach = model("vehicles/manchester-coach.xml");
    const std::string paper = model("vehicles/al-oraiqat-2017.xml");
    return {
        {"info", {"info", coach}, true},
        {"info of a train", {"info", model("trains/three-coaches.xml")}, true},
        {"modes", {"modes", coach}, true},
        {"simulate", {"simulate", coach, path("short.xml")}, false},
        {"validate", {"validate", paper, path("short.xml"), "--serial", "--details"}, false},
        {"validate of a suite", {"validate", path("suite.xml")}, false},
        {"study show, side by side", {"study", "show", path("named.sqlite")}, true},
        {"study show, a sweep", {"study", "show", path("sweep.sqlite")}, true},
        {"study", {"study", path("study.xml"), "--output", path("new.sqlite"), "--overwrite"}, false},
        {"profile", {"profile", path("v.xml"), path("short.xml"), "--threads", "2"}, false},
        {"profile --realtime", {"profile", path("v.xml"), path("short.xml"), "--realtime", "1 ms"}, false},
    };
  }

 private:
  OutputFiles files_;
};

TEST_F(PageWidth, NoLineIsWiderThanThePageAndEveryWordIsThere) {
  for (const Printed& each : commands()) {
    const ProgramRun whole = runVehicle(each.words);
    ASSERT_EQ(whole.status, 0) << each.name << whole.err;
    const std::map<std::string, int> parts = partsOf(whole.out);
    for (const std::size_t width : {60u, 80u, 200u}) {
      const Columns columns(std::to_string(width));
      const ProgramRun run = runVehicle(each.words);
      ASSERT_EQ(run.status, 0) << each.name;
      for (const std::string& line : linesOf(run.out)) {
        EXPECT_LE(lettersIn(line), width) << each.name << ": " << line;
      }
      if (!each.repeats) continue;
      const std::map<std::string, int> found = partsOf(run.out);
      for (const auto& [part, count] : parts) {
        const auto there = found.find(part);
        EXPECT_TRUE(there != found.end() && there->second >= count)
            << each.name << " at " << width << ": " << part << " is lost";
      }
    }
  }
}

// 12 columns of a coach: a narrow page needs more lines, a pipe has no width.
TEST_F(PageWidth, IsThatOfTheTerminalAndOfAFileNone) {
  const Words words = {"info", model("vehicles/manchester-coach.xml")};
  const std::string whole = runVehicle(words).out;
  const ProgramRun narrow = runVehicleOnTerminal(words, 50);
  ASSERT_EQ(narrow.status, 0) << narrow.err;
  EXPECT_GT(linesOf(narrow.out).size(), linesOf(whole).size());
  std::size_t widest = 0;
  for (const std::string& line : linesOf(narrow.out)) widest = std::max(widest, lettersIn(line));
  EXPECT_LE(widest, 50u);
  EXPECT_EQ(runVehicleOnTerminal(words, 500).out, whole);
  // COLUMNS comes before the terminal; what is no width is not looked at.
  {
    const Columns columns("500");
    EXPECT_EQ(runVehicleOnTerminal(words, 50).out, whole);
  }
  for (const char* no_width : {"", "0", "-5", "wide", "80x"}) {
    const Columns columns(no_width);
    EXPECT_EQ(runVehicle(words).out, whole) << no_width;
    EXPECT_EQ(runVehicleOnTerminal(words, 50).out, narrow.out) << no_width;
  }
}

TEST_F(PageWidth, OfCsvAndJsonIsNone) {
  for (const char* format : {"csv", "json"}) {
    const Words words = {"info", model("vehicles/manchester-coach.xml"), "--format", format};
    const std::string whole = runVehicle(words).out;
    const Columns columns("40");
    EXPECT_EQ(runVehicle(words).out, whole) << format;
  }
}

TEST_F(PageWidth, OfHelpIsAHundredLettersOrThatOfTheTerminal) {
  Words pages = vehicle::test::commands();
  pages.insert(pages.begin(), "");
  for (const std::string& command : pages) {
    Words words = {command, "--help"};
    if (command.empty()) words.erase(words.begin());
    const ProgramRun whole = runVehicle(words);
    for (const std::string& line : linesOf(whole.out)) EXPECT_LE(lettersIn(line), 100u) << line;
    const Columns columns("72");
    const ProgramRun narrow = runVehicle(words);
    bool is_command = false;
    for (const std::string& line : linesOf(narrow.out)) {
      // A command is there to be copied and is not broken.
      const bool goes_on = is_command && line.starts_with("      ");
      is_command = line.starts_with("Example: ") || goes_on;
      if (is_command) continue;
      EXPECT_LE(lettersIn(line), 72u) << line;
    }
    EXPECT_EQ(partsOf(narrow.out), partsOf(whole.out)) << command;
  }
}

}  // namespace
}  // namespace vehicle::test
