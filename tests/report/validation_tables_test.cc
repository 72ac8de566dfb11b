#include "libvehicle/report/validation/validation_tables.h"

#include <gtest/gtest.h>

#include "libvehicle/validation/overall.h"

namespace vehicle::report {
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
  for (ValidationRun& run : report.runs) run.ending = RunEnding::kFinished;
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

Overall statusOf(const std::vector<ValidationReport>& reports, Unjudged unjudged = Unjudged::kFail) {
  return overallOf(reports, unjudged);
}

/// The second run was given up: its pair is not judged.
ValidationReport busyReport() {
  ValidationReport report = reportWith(Verdict::kNotJudged);
  report.runs[1].ending = RunEnding::kOutOfTime;
  report.runs[1].reason = "not done after 1 s, its time limit";
  report.pairs[0].columns.clear();
  report.pairs[0].why = "mbs rk4: " + report.runs[1].reason;
  return report;
}

TEST(ValidationTables, APairOutsideDoesNotHoldAndIsNamedWithItsColumn) {
  const ValidationReport report = reportWith(Verdict::kOutside);
  EXPECT_EQ(statusOf({reportWith(Verdict::kInside), report}), Overall::kDoesNotHold);
  ASSERT_EQ(complaintsOf(report).size(), 1u);
  EXPECT_EQ(complaintsOf(report)[0],
            "coach on waves at 72 km/h: matrix exact against mbs rk4: carbody.z differs by 0.03 mm, expected at most "
            "1e-09 mm "
            "(rounding: same equations)");
}

TEST(ValidationTables, AllInsideHoldsAndNothingIsSaid) {
  EXPECT_EQ(statusOf({reportWith(Verdict::kInside)}), Overall::kHolds);
  EXPECT_TRUE(complaintsOf(reportWith(Verdict::kInside)).empty());
}

TEST(ValidationTables, ARunThatFailedComesBeforeAPairOutside) {
  ValidationReport report = reportWith(Verdict::kOutside);
  report.runs[1].ending = RunEnding::kFailed;
  report.runs[1].reason = "mbs with rk4: carbody.z is not finite at t = 1 s";
  EXPECT_EQ(statusOf({report}), Overall::kFailed);
  EXPECT_EQ(complaintsOf(report)[0], "coach on waves at 72 km/h: mbs with rk4: carbody.z is not finite at t = 1 s");
}

TEST(ValidationTables, NothingThatWasJudgedIsNotAPass) {
  EXPECT_EQ(statusOf({reportWith(Verdict::kByDesign)}), Overall::kDoesNotHold);
}

TEST(ValidationTables, AnEarlyEndIsAnInterruptionUnlessAPairIsOutside) {
  ValidationReport stopped;
  stopped.stopped = true;
  EXPECT_EQ(statusOf({reportWith(Verdict::kInside), stopped}), Overall::kInterrupted);
  EXPECT_EQ(statusOf({reportWith(Verdict::kOutside), stopped}), Overall::kDoesNotHold);
}

TEST(ValidationTables, APairThatWasNotJudgedIsNoPassUnlessItIsAccepted) {
  ValidationReport mixed = reportWith(Verdict::kInside);
  mixed.runs.push_back(busyReport().runs[1]);
  mixed.pairs.push_back(busyReport().pairs[0]);
  mixed.pairs[1].second = 2;
  EXPECT_EQ(statusOf({mixed}), Overall::kDoesNotHold);
  EXPECT_EQ(statusOf({mixed}, Unjudged::kAccept), Overall::kHolds);
  EXPECT_EQ(statusOf({mixed, reportWith(Verdict::kOutside)}, Unjudged::kAccept), Overall::kDoesNotHold);
  ASSERT_EQ(complaintsOf(mixed).size(), 1u);
  EXPECT_EQ(complaintsOf(mixed)[0],
            "coach on waves at 72 km/h: mbs rk4 is not judged: not done after 1 s, its time limit");
  EXPECT_EQ(documentOf(mixed, Detail::kAll).remarks.back(),
            "1 pairs inside their expected size, 0 outside, 1 not judged");
  EXPECT_EQ(documentOf({mixed, mixed}).remarks.back(), "2 pairs inside their expected size, 0 outside, 2 not judged");
}

TEST(ValidationTables, AcceptingWhatIsNotJudgedAcceptsNoEmptyVerdict) {
  EXPECT_EQ(statusOf({busyReport()}), Overall::kDoesNotHold);
  EXPECT_EQ(statusOf({busyReport()}, Unjudged::kAccept), Overall::kDoesNotHold);
  // Another case that was judged decides for both.
  EXPECT_EQ(statusOf({busyReport(), reportWith(Verdict::kInside)}), Overall::kDoesNotHold);
  EXPECT_EQ(statusOf({busyReport(), reportWith(Verdict::kInside)}, Unjudged::kAccept), Overall::kHolds);
}

TEST(ValidationTables, ACaseThatComparesNothingSaysWhy) {
  EXPECT_EQ(whyNothing(reportWith(Verdict::kInside)), "");
  EXPECT_EQ(whyNothing(busyReport()), "");  // its runs have said it
  ValidationReport alone = reportWith(Verdict::kInside);
  alone.runs.resize(1);
  alone.pairs.clear();
  alone.unsupported = {{"flat", "", "the vehicle has one bogie"}};
  EXPECT_EQ(
      whyNothing(alone),
      "coach on waves at 72 km/h: nothing is judged: no two runs can be compared; flat: the vehicle has one bogie");
  EXPECT_EQ(statusOf({alone}), Overall::kDoesNotHold);
  EXPECT_EQ(statusOf({alone, reportWith(Verdict::kInside)}), Overall::kDoesNotHold);
}

}  // namespace
}  // namespace vehicle::report
