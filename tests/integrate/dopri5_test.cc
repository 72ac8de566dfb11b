#include "libvehicle/integrate/dopri5.h"

#include <stdexcept>

#include "libvehicle/integrate/adaptive_steps.h"
#include "libvehicle/integrate/system_rhs.h"
#include "tests/integrate/cases.h"
#include "tests/support/tolerance.h"

namespace vehicle::test {
namespace {

double errorAt(const Case& problem, Accuracy accuracy, Statistics* statistics = nullptr) {
  return worstError(problem, 0.01, [&](const auto& s, const auto& i, const auto& g, const auto& x, const auto& o) {
    const Statistics cost = runDopri5({s, i, g, x}, accuracy, o);
    if (statistics != nullptr) *statistics = cost;
    return cost;
  });
}

TEST(Dopri5, TighterTolerancesGiveSmallerErrorsInProportion) {
  for (const Case& problem : allCases()) {
    // Amplitudes are mm and some 10 mm/s, so the absolute tolerance must stay well below 1e-3 of the relative one.
    for (const double relative : {1e-4, 1e-6, 1e-8, 1e-10}) {
      const double error = errorAt(problem, {.relative = relative, .absolute = 1e-4 * relative});
      // Local errors add over the few steps that the damping remembers.
      EXPECT_LT(error, 30.0 * relative) << problem.name;
    }
  }
}

// Steps of one size through a smooth rail: error of the step's end O(h^5), between O(h^5) as well, as the interpolant
// errs by h^5 once and not h^4 as the sum of the steps may.
double denseError(double h) {
  const Case problem = caseOf("sine", bounce(), sineRail(), {0.002, 0.01});
  Dopri5<SystemRhs> stepper(SystemRhs(problem.system), 2);
  double u[7][2], worst = 0.0;
  problem.input.evaluate(0, 0.0, u[0]);
  stepper.begin(problem.start.data(), u[0]);
  for (int k = 0; k < static_cast<int>(std::lround(1.0 / h)); ++k) {
    for (std::size_t i = 0; i < 7; ++i) problem.input.evaluate(0, (k + kDopri5.c[i]) * h, u[i]);
    stepper.attempt(h, u[0], 2);
    for (const double s : {0.1, 0.25, 0.5, 0.75, 0.9}) {
      double x[2];
      stepper.dense(s, x);
      worst = std::max(worst, std::abs(x[0] - problem.truth((k + s) * h)[0]));
    }
    stepper.accept();
  }
  return worst;
}

TEST(Dopri5, DenseOutputIsOfOrderFourOrBetter) {
  const double ratio = denseError(0.02) / denseError(0.01);
  // h^5 inside a step gives 32, a sum of local errors of order 4 would give 16; order 3 would give 8 to 16.
  EXPECT_GT(ratio, 15.0);
  EXPECT_LT(ratio, 40.0);
  EXPECT_GT(denseError(0.01), 1e-14);
}

TEST(Dopri5, DenseOutputMeetsBothEndsOfTheStep) {
  const Case problem = caseOf("sine", bounce(), sineRail(), {0.002, 0.01});
  Dopri5<SystemRhs> stepper(SystemRhs(problem.system), 2);
  double u[7][2], x[2];
  for (std::size_t i = 0; i < 7; ++i) problem.input.evaluate(0, kDopri5.c[i] * 0.02, u[i]);
  stepper.begin(problem.start.data(), u[0]);
  stepper.attempt(0.02, u[0], 2);
  stepper.dense(0.0, x);
  EXPECT_EQ(x[0], problem.start[0]);
  stepper.dense(1.0, x);
  EXPECT_WITHIN(x[0], stepper.proposal()[0], 1e-17);  // sums of mm in another order
  EXPECT_WITHIN(x[1], stepper.proposal()[1], 1e-16);
}

TEST(Dopri5, EvaluationsAreSixAnAttemptAndOneAtEveryBreakpointAndTwoToBegin) {
  const Case problem = caseOf("dip", bounce(), halfSineDipRail());
  Statistics statistics;
  (void)errorAt(problem, {.relative = 1e-8, .absolute = 1e-12}, &statistics);
  EXPECT_EQ(statistics.evaluations, 6 * (statistics.steps + statistics.rejected) + 3 + 1);
  EXPECT_GT(statistics.rejected, 0);  // a flat rail lets the steps grow until the dip begins
}

TEST(Dopri5, StepsDoNotFollowTheOutputSamples) {
  const Case problem = caseOf("sine", bounce(), sineRail(), {0.002, 0.01});
  const auto stepsFor = [&](double output_step) {
    return runDopri5({problem.system, problem.input, Schedule(problem.input, output_step), problem.start}, {},
                     [](int, int, double, std::span<const double>) { return true; })
        .steps;
  };
  EXPECT_EQ(stepsFor(1e-4), stepsFor(1.0));
}

// 2 s of flat rail let the steps grow to 2 s; the bump of 4 ms that follows is a segment, and so cannot be missed.
TEST(Dopri5, SeesANarrowBumpAfterALongQuietRail) {
  const double w = std::acos(-1.0) / 0.004;
  const std::vector<RailPiece> rail = {
      {0.0, 2.0, 0.0, 0.0, {}}, {2.0, 2.004, 0.0, 0.0, {{w, {0.0, -0.01}}}}, {2.004, 3.0, 0.0, 0.0, {}}};
  EXPECT_LT(errorAt(caseOf("bump", bounce(), rail), {}), 1e-8);
}

// 50 Hz under a vehicle at rest: all stages but one of a step of 1 s would read sin = 0.
TEST(Dopri5, SeesAFastSineThatBeginsUnderALongStep) {
  const double w = 100.0 * std::acos(-1.0);
  const std::vector<RailPiece> rail = {{0.0, 1.0, 0.0, 0.0, {}}, {1.0, 3.0, 0.0, 0.0, {{w, {0.0, -0.001}}}}};
  // A sine not seen is an error of one. The mass moves by a hundredth of the rail, so atol counts for more.
  EXPECT_LT(errorAt(caseOf("50 Hz", bounce(), rail), {}), 1e-7);
}

TEST(Dopri5, MaximumStepIsKept) {
  const Case problem = caseOf("rest", bounce(), flatRail());
  const auto steps = [&](double max_step) {
    Statistics statistics;
    statistics = runDopri5({problem.system, problem.input, Schedule(problem.input, 1.0), problem.start},
                           {.max_step = max_step}, [](int, int, double, std::span<const double>) { return true; });
    return statistics.steps;
  };
  EXPECT_LT(steps(0.0), 30);
  EXPECT_GE(steps(0.01), 300);
}

TEST(Dopri5, BlowUpInFiniteTimeNamesTheTime) {
  // x' = x^2 from 1: infinite at t = 1.
  const ExpressionSystem system(1, 1, [](const double* x, const double*, double* dx) { dx[0] = x[0] * x[0]; });
  const Input input = caseOf("flat", bounce(), flatRail(2.0)).input;
  const std::vector<double> start = {1.0};
  try {
    runDopri5({system, input, Schedule(input, 0.1), start}, {},
              [](int, int, double, std::span<const double>) { return true; });
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    const std::size_t at = text.find(" at t = ");
    ASSERT_NE(at, std::string::npos) << text;
    EXPECT_NEAR(std::stod(text.substr(at + 8)), 1.0, 1e-6) << text;
  }
}

TEST(Dopri5, RefusesTolerancesThatCannotBeMet) {
  EXPECT_THROW(checkAccuracy("dopri5", {.relative = 1e-16}), std::invalid_argument);
  EXPECT_THROW(checkAccuracy("dopri5", {.relative = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(checkAccuracy("dopri5", {.absolute = 0.0}), std::invalid_argument);
  EXPECT_THROW(checkAccuracy("dopri5", {.max_step = -1.0}), std::invalid_argument);
  try {
    checkAccuracy("dopri5", {.relative = 2.0});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "dopri5: relative tolerance = 2, must be 1e-14 or more and below 1");
  }
}

TEST(StepControl, GrowsAtMostFivefoldShrinksAtMostTenfoldAndNeverGrowsAfterARejection) {
  StepControl control(5);
  EXPECT_DOUBLE_EQ(control.afterAccepted(1.0, 0.0), 5.0);
  EXPECT_DOUBLE_EQ(control.afterRejected(1.0, 1e30), 0.1);
  EXPECT_DOUBLE_EQ(control.afterRejected(1.0, std::nan("")), 0.1);
  EXPECT_LE(control.afterAccepted(1.0, 1e-9), 1.0);
  EXPECT_GT(control.afterAccepted(1.0, 1e-9), 1.0);
}

TEST(LongestStep, IsAQuarterOfTheShortestPeriod) {
  InputSegment segment;
  EXPECT_TRUE(std::isinf(longestStep(segment)));
  segment.angular_frequency = {2.0 * std::acos(-1.0), 20.0 * std::acos(-1.0)};
  EXPECT_DOUBLE_EQ(longestStep(segment), 0.025);
}

}  // namespace
}  // namespace vehicle::test
