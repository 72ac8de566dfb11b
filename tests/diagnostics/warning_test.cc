#include "libvehicle/diagnostics/warning_set.h"

#include <cctype>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "libvehicle/diagnostics/warning_collector.h"
#include "tests/support/source_tree.h"

namespace vehicle {
namespace {

TEST(Warning, TextIsOneLineWithPlaceSubjectRemedyAndCode) {
  Warning warning;
  warning.code = WarningCode::kWheelLoad;
  warning.subject = "axle.load";
  warning.message = "-129 kN at t = 0.53 s; a rail only pushes";
  EXPECT_EQ(warning.text(), "warning: axle.load: -129 kN at t = 0.53 s; a rail only pushes [WHEEL_LOAD]");
  warning.place = {"wagon.xml", 7};
  warning.remedy = "run slower";
  EXPECT_EQ(warning.text(),
            "wagon.xml:7: warning: axle.load: -129 kN at t = 0.53 s; a rail only pushes; run slower [WHEEL_LOAD]");
}

TEST(WarningCollector, KeepsWhatIsSaidOfTheVehicleOnceAndOfAMotionWithItsRun) {
  Warning vehicle;
  vehicle.code = WarningCode::kSamePlace;
  vehicle.subject = "axle_1";
  Warning motion;
  motion.code = WarningCode::kWheelLoad;
  motion.subject = "axle_1.load";
  motion.time = 0.5;
  WarningCollector collector;
  collector.add({vehicle, motion}, "at 80 km/h");
  collector.add({vehicle, motion}, "at 90 km/h");
  const Warnings all = collector.take();
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].subject, "axle_1");
  EXPECT_EQ(all[1].subject, "at 80 km/h: axle_1.load");
  EXPECT_EQ(all[2].subject, "at 90 km/h: axle_1.load");
}

TEST(WarningCollector, OfOneRunLeavesItsWarningsAsTheyAre) {
  Warning motion;
  motion.subject = "axle_1.load";
  motion.time = 0.5;
  WarningCollector collector;
  collector.add({motion, motion});
  const Warnings all = collector.take();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].text(), motion.text());
}

TEST(WarningSet, IsWrittenInTheOrderOfTheCodesAndReadBack) {
  WarningSet set;
  EXPECT_TRUE(set.empty());
  EXPECT_EQ(set.words(), "");
  EXPECT_EQ(WarningSet::ofWords(""), set);
  for (const WarningCode code : {WarningCode::kNothingJudged, WarningCode::kWheelLoad, WarningCode::kWheelLoad}) {
    set.insert(code);
  }
  EXPECT_EQ(set.words(), "WHEEL_LOAD NOTHING_JUDGED");
  EXPECT_EQ(WarningSet::ofWords(set.words()), set);
  EXPECT_EQ(WarningSet::ofWords("WHEEL_LOAD OF_A_LATER_PROGRAM NOTHING_JUDGED"), set);
  EXPECT_FALSE(set.contains(WarningCode::kLargeMotion));
}

TEST(WarningKinds, StandInTheOrderOfTheirCodesAndHaveAWordAndASentenceEach) {
  std::set<std::string_view> words;
  int code = 0;
  for (const WarningKind& kind : warningKinds()) {
    EXPECT_EQ(static_cast<int>(kind.code), code++);
    EXPECT_EQ(wordOf(kind.code), kind.word);
    EXPECT_TRUE(words.insert(kind.word).second) << kind.word;
    EXPECT_TRUE(kind.sentence.ends_with('.')) << kind.word;
    for (const char c : kind.word) EXPECT_TRUE(c == '_' || std::isupper(static_cast<unsigned char>(c))) << kind.word;
  }
}

TEST(WarningKinds, AreAllListedOnThePageInTheirOrder) {
  std::string rows;
  for (const WarningKind& kind : warningKinds()) {
    rows.append("| `").append(kind.word).append("` | ").append(kind.sentence).append(" |\n");
  }
  std::ostringstream page;
  page << std::ifstream(test::sourcePath("docs/warnings.md")).rdbuf();
  EXPECT_NE(page.str().find("|---|---|\n" + rows), std::string::npos) << "docs/warnings.md should list:\n" << rows;
}

}  // namespace
}  // namespace vehicle
