#include "libvehicle/storage/line_diff.h"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace vehicle {
namespace {

/// "2:-b+x" for a line replaced, "2:+x" new, "2:-b" gone.
std::string told(const std::string& before, const std::string& now) {
  std::string text;
  for (const LineChange& change : lineDiff(before, now)) {
    text += (text.empty() ? "" : " ") + std::to_string(change.line) + ':';
    if (change.was) text += '-' + *change.was;
    if (change.is) text += '+' + *change.is;
  }
  return text;
}

TEST(LineDiff, EqualTextsDoNotDiffer) {
  EXPECT_EQ(told("", ""), "");
  EXPECT_EQ(told("a\nb\n", "a\nb\n"), "");
  EXPECT_EQ(told("a\r\nb", "a\nb\n"), "");
}

TEST(LineDiff, TellsLinesReplacedNewAndGoneAtTheirPlaceInTheNewText) {
  EXPECT_EQ(told("a\nb\nc\n", "a\nx\nc\n"), "2:-b+x");
  EXPECT_EQ(told("a\nc\n", "a\nb\nc\n"), "2:+b");
  EXPECT_EQ(told("a\nb\nc\n", "a\nc\n"), "2:-b");
  EXPECT_EQ(told("", "a\n"), "1:+a");
  EXPECT_EQ(told("a\nb\n", ""), "1:-a 1:-b");
  EXPECT_EQ(told("a\nb\nc\nd\ne\n", "a\nB\nc\nd\nnew\ne\n"), "2:-b+B 5:+new");
}

// The old text, with what is gone put in and what is new taken out, is rebuilt from the new one.
TEST(LineDiff, TheChangesLeadFromTheNewTextBackToTheOldOne) {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    std::vector<std::string> before(random() % 12);
    for (std::string& line : before) line = std::string(1, static_cast<char>('a' + random() % 4));
    std::vector<std::string> now = before;
    for (int edit = 0; edit < 3; ++edit) {
      const std::size_t at = now.empty() ? 0 : random() % now.size();
      if (random() % 2 == 0 || now.empty()) {
        now.insert(now.begin() + static_cast<std::ptrdiff_t>(at), "new");
      } else {
        now.erase(now.begin() + static_cast<std::ptrdiff_t>(at));
      }
    }
    const auto joined = [](const std::vector<std::string>& lines) {
      std::string text;
      for (const std::string& line : lines) text += line + '\n';
      return text;
    };
    std::vector<std::string> rebuilt;
    std::size_t line = 1;
    for (const LineChange& change : lineDiff(joined(before), joined(now))) {
      for (; line < change.line; ++line) rebuilt.push_back(now[line - 1]);
      if (change.was) rebuilt.push_back(*change.was);
      if (change.is) {
        EXPECT_EQ(now[line - 1], *change.is);
        ++line;
      }
    }
    for (; line <= now.size(); ++line) rebuilt.push_back(now[line - 1]);
    EXPECT_EQ(rebuilt, before);
  }
}

}  // namespace
}  // namespace vehicle
