#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/test_folder.h"

// Jobs of several ranks on this machine: rank_program.cc under mpirun. Ranks may outnumber the cores here.
namespace vehicle {
namespace {

class Ranks : public testing::Test {
 protected:
  /// @returns the exit status of mpirun, -1 if it was killed
  int run(int ranks, const std::string& which, const std::string& file, int threads = 1) const {
    const std::string environment =
        "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_btl_vader_single_copy_mechanism=none ";
    const std::string command = environment + "timeout 600 " VEHICLE_MPIRUN " --oversubscribe --bind-to none -n " +
                                std::to_string(ranks) + " " VEHICLE_RANK_PROGRAM " " + which + " " +
                                folder_.path(file) + " " + std::to_string(threads) + " > " + folder_.path("log") +
                                " 2>&1";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string text(const std::string& file) const { return test::textOf(folder_.path(file)); }

  test::TestFolder folder_;
};

TEST_F(Ranks, AnyNumberOfThemGivesTheSameTable) {
  ASSERT_EQ(run(1, "whole", "one"), 0) << text("log");
  // 25'001 designs of a number and four values, a gap in 25 of them and a warning of 26 (each 997th).
  ASSERT_EQ(text("one").size(), (25'001u * 5u + 25u + 26u) * 8u);
  for (const int ranks : {2, 4}) {
    EXPECT_EQ(run(ranks, "whole", "many"), 0) << text("log");
    EXPECT_TRUE(text("many") == text("one")) << ranks << " ranks";
  }
}

TEST_F(Ranks, ThreadsOfRanksGiveTheSameTable) {
  ASSERT_EQ(run(1, "whole", "one"), 0) << text("log");
  EXPECT_EQ(run(2, "whole", "many", 2), 0) << text("log");
  EXPECT_TRUE(text("many") == text("one"));
}

TEST_F(Ranks, AStoppedRunLeavesThemReadyForAnother) {
  ASSERT_EQ(run(1, "whole", "one"), 0) << text("log");
  EXPECT_EQ(run(3, "stop", "many"), 0) << text("log");
  EXPECT_TRUE(text("many") == text("one"));
}

TEST_F(Ranks, ASinkThatThrowsLeavesThemReadyForAnother) {
  ASSERT_EQ(run(1, "whole", "one"), 0) << text("log");
  EXPECT_EQ(run(3, "sink", "many"), 0) << text("log");
  EXPECT_TRUE(text("many") == text("one"));
}

TEST_F(Ranks, WhatEndsOneOfThemEndsTheRun) {
  ASSERT_EQ(run(3, "failure", "error"), 0) << text("log");
  EXPECT_NE(text("error").find("a mistake of ours"), std::string::npos) << text("error");
}

TEST_F(Ranks, OneThatCannotBeginEndsTheRun) {
  ASSERT_EQ(run(2, "absent", "error"), 0) << text("log");
  EXPECT_EQ(text("error"), "rank 1: it could not evaluate the study; its own message tells why");
}

TEST_F(Ranks, ALostOneEndsTheJobInsteadOfHangingIt) {
  const int status = run(3, "lost", "table");
  EXPECT_NE(status, 0);
  EXPECT_NE(status, 124) << "it hung until the time was up";
}

TEST_F(Ranks, AStudyWhoseRankWasLostGoesOnToTheSameTable) {
  ASSERT_EQ(run(1, "stored", "whole"), 0) << text("log");
  EXPECT_NE(run(3, "stored-lost", "parts"), 0);
  EXPECT_EQ(text("parts.csv"), "");  // it did end in the middle
  EXPECT_EQ(run(2, "stored", "parts"), 0) << text("log");
  EXPECT_GT(text("whole.csv").size(), 1'000'000u);
  EXPECT_TRUE(text("parts.csv") == text("whole.csv"));
}

}  // namespace
}  // namespace vehicle
