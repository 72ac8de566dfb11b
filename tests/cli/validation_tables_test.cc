#include "apps/cli/validation_tables.h"

#include <gtest/gtest.h>

#include "apps/cli/exit_status.h"

namespace vehicle::cli {
namespace {

/// Two runs and their pair. No vehicle can be had whose forms disagree, so the verdict is set by hand.
ValidationReport reportWith(Verdict verdict) {
  ValidationReport report;
  report.vehicle = "coach";
  report.scenario = "waves";
  report.speed = 20.0;
  report.runs.resize(2);
  report.runs[0].key.form = "matrix";
  report.runs[0].key.method = "exact";
  report.runs[1].key.form = "mbs";
  report.runs[1].key.method = "rk4";
  PairAgreement pair;
  pair.second = 1;
  pair.verdict = verdict;
  pair.why = "rounding: same equations";
  ColumnAgreement column;
  column.column = {"carbody.z", "m"};
  column.norms.max_difference = 3e-5;
  column.expected = 1e-12;
  pair.columns = {column};
  report.pairs = {pair};
  return report;
}

TEST(ValidationTables, APairOutsideEndsWithFourAndIsNamedWithItsColumn) {
  const ValidationReport report = reportWith(Verdict::kOutside);
  EXPECT_EQ(exitStatusOf({reportWith(Verdict::kInside), report}), kCheckDidNotHold);
  ASSERT_EQ(complaintsOf(report).size(), 1u);
  EXPECT_EQ(
      complaintsOf(report)[0],
      "coach on waves at 20 m/s: matrix exact against mbs rk4: carbody.z differs by 3e-05 m, expected at most 1e-12 m "
      "(rounding: same equations)");
}

TEST(ValidationTables, AllInsideEndsWithZeroAndNothingIsSaid) {
  EXPECT_EQ(exitStatusOf({reportWith(Verdict::kInside)}), kDone);
  EXPECT_TRUE(complaintsOf(reportWith(Verdict::kInside)).empty());
}

TEST(ValidationTables, ARunThatFailedComesBeforeAPairOutside) {
  ValidationReport report = reportWith(Verdict::kOutside);
  report.runs[1].failure = "mbs with rk4: carbody.z is not finite at t = 1 s";
  EXPECT_EQ(exitStatusOf({report}), kRunFailed);
  EXPECT_EQ(complaintsOf(report)[0], "coach on waves at 20 m/s: mbs with rk4: carbody.z is not finite at t = 1 s");
}

TEST(ValidationTables, NothingThatWasJudgedIsNotAPass) {
  EXPECT_EQ(exitStatusOf({reportWith(Verdict::kByDesign)}), kCheckDidNotHold);
}

TEST(ValidationTables, AnEarlyEndIsOneHundredAndThirtyUnlessAPairIsOutside) {
  ValidationReport stopped;
  stopped.stopped = true;
  EXPECT_EQ(exitStatusOf({reportWith(Verdict::kInside), stopped}), kInterrupted);
  EXPECT_EQ(exitStatusOf({reportWith(Verdict::kOutside), stopped}), kCheckDidNotHold);
}

}  // namespace
}  // namespace vehicle::cli
