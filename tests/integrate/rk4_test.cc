#include "libvehicle/integrate/rk4.h"

#include <cstring>
#include <stdexcept>

#include "libvehicle/integrate/fixed_steps.h"
#include "libvehicle/integrate/system_rhs.h"
#include "tests/integrate/cases.h"
#include "tests/support/tolerance.h"

namespace vehicle::test {
namespace {

double errorAt(const Case& problem, int refine) {
  return worstError(problem, 0.01, [&](const auto& s, const auto& i, const auto& g, const auto& x, const auto& o) {
    return runRk4({s, i, g, x}, {.step = 5e-3, .refine = refine}, o);
  });
}

// Order 4: half the step, 1/16 of the error. At w h <= 0.1 the next term changes the ratio by some w h / 5 = 2 %, and
// rounding (1e-15) is six decades below the error. Error = the largest over the run: at a single instant it may sit
// on a zero and lie about the order. Straddled breakpoints would give a ratio near 2.
TEST(Rk4, HalvingEveryStepDividesTheErrorBySixteenAcrossBreakpointsToo) {
  for (const Case& problem : allCases()) {
    const double ratio = errorAt(problem, 1) / errorAt(problem, 2);
    EXPECT_GT(ratio, 15.0) << problem.name;
    EXPECT_LT(ratio, 17.0) << problem.name;
    EXPECT_GT(errorAt(problem, 2), 1e-11) << problem.name << ": at rounding, a ratio says nothing";
  }
}

TEST(Rk4, OneStepIsExactForACubicInTime) {
  Rk4 stepper([](const double*, const double* u, double* dx) { dx[0] = u[0]; }, 1);
  const auto cubic = [](double t) { return 1.0 - 2.0 * t + 3.0 * t * t - 4.0 * t * t * t; };
  double x = 0.5;
  const double h = 0.8, u0 = cubic(0.0), u1 = cubic(0.5 * h), u2 = cubic(h);
  stepper.step(h, &u0, &u1, &u2, &x);
  // A few roundings of numbers near one.
  EXPECT_WITHIN(x, 0.5 + h - h * h + h * h * h - h * h * h * h, 1e-15);
}

TEST(Rk4, OneStepOfALinearSystemIsItsTaylorSeriesToTheFourthPower) {
  Rk4<void (*)(const double*, const double*, double*), 1> stepper(
      [](const double* x, const double*, double* dx) { dx[0] = -1.5 * x[0]; });
  double x = 2.0;
  const double none = 0.0, z = -1.5 * 0.4;
  stepper.step(0.4, &none, &none, &none, &x);
  EXPECT_WITHIN(x, 2.0 * (1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))), 1e-15);
}

struct DuffingRhs {
  void operator()(const double* x, const double* u, double* dx) const {
    dx[0] = x[1];
    dx[1] = -40.0 * (x[0] - u[0]) - 3.0 * (x[1] - u[1]) - 2e4 * x[0] * x[0] * x[0];
  }
};

// The size known to the compiler, or found through a virtual call: who computes changes, never what. Equal, not near.
TEST(Rk4, StaticAndVirtualPathGiveTheSameBits) {
  const Input input = inputOf({sineOnsetRail()});
  const Schedule schedule(input, 0.01);
  const std::vector<double> start = {0.01, -0.2};
  std::vector<double> direct, adapted;
  const auto keep = [](std::vector<double>& into) {
    return [&into](int, int, double, std::span<const double> x) {
      into.insert(into.end(), x.begin(), x.end());
      return true;
    };
  };
  Rk4<DuffingRhs, 2> stepper(DuffingRhs{});
  (void)FixedSteps(stepper, input, {.step = 1e-3}).run(schedule, start, keep(direct));
  const ExpressionSystem system(2, 1, DuffingRhs{});
  (void)runRk4({system, input, schedule, start}, {.step = 1e-3}, keep(adapted));
  ASSERT_EQ(direct.size(), 602u);
  EXPECT_EQ(std::memcmp(direct.data(), adapted.data(), direct.size() * sizeof(double)), 0);
}

TEST(Rk4, CutOfTheInputIntoBlocksLeavesNoTrace) {
  // One interval of 3 s in 3000 steps, against the same steps with the input of each asked by itself.
  const Case problem = caseOf("sine", bounce(), sineRail(), {0.002, 0.01});
  const auto run = [](const auto& s, const auto& i, const auto& g, const auto& x, const auto& o) {
    return runRk4({s, i, g, x}, {.step = 1e-3}, o);
  };
  const double error = worstError(problem, 3.0, run);
  Rk4<SystemRhs> stepper(SystemRhs(problem.system), 2);
  std::vector<double> x = problem.start;
  double u[3][2];
  for (int k = 0; k < 3000; ++k) {
    for (int part = 0; part < 3; ++part) problem.input.evaluate(0, (k + 0.5 * part) * 1e-3, u[part]);
    stepper.step(1e-3, u[0], u[1], u[2], x.data());
  }
  const std::vector<double> truth = problem.truth(3.0);
  double asked = 0.0;
  const std::vector<double> begin = problem.truth(0.0);
  for (std::size_t i = 0; i < 2; ++i) {
    asked = std::max(asked, std::abs(x[i] - truth[i]) / std::max(std::abs(truth[i]), std::abs(begin[i])));
  }
  // The sweep's own bound is some 1e-13 of the amplitude; a row read at the wrong place would show at 1e-3.
  EXPECT_WITHIN(error, asked, 1e-12);
}

TEST(Rk4, FourEvaluationsAStepAndStepsThatDivideEveryInterval) {
  // Intervals of 10 ms, of 3.7 + 6.3 ms around the breakpoint at 0.3137 s, all in steps of at most 4 ms, each cut in two.
  const Case problem = caseOf("onset", bounce(), sineOnsetRail());
  long calls = 0;
  const ExpressionSystem counted(2, 1, [&](const double* x, const double* u, double* dx) {
    ++calls;
    DuffingRhs{}(x, u, dx);
  });
  const Statistics statistics =
      runRk4({counted, problem.input, Schedule(problem.input, 0.01), problem.start}, {.step = 4e-3, .refine = 2},
             [](int, int, double, std::span<const double>) { return true; });
  EXPECT_EQ(statistics.steps, 2 * (299 * 3 + 1 + 2));
  EXPECT_EQ(statistics.evaluations, 4 * statistics.steps);
  EXPECT_EQ(statistics.evaluations, calls);
  EXPECT_EQ(statistics.rejected, 0);
}

TEST(StepGrid, SharesWholeOutputStepsOfOneSegmentAndStopsAtTheBreakpoint) {
  const Input input = inputOf({sineOnsetRail(0.3137)});
  const Schedule schedule(input, 0.01);
  const StepGrid before = stepGridFrom(schedule.intervals()[0], {.step = 4e-3});
  EXPECT_EQ(before.count, 31);
  EXPECT_EQ(before.steps, 3);
  EXPECT_DOUBLE_EQ(before.h, 0.01 / 3);
  const StepGrid to_breakpoint = stepGridFrom(schedule.intervals()[31], {.step = 4e-3});
  EXPECT_EQ(to_breakpoint.count, 1u);
  EXPECT_WITHIN(to_breakpoint.h, 0.0037, 1e-15);  // a difference of instants
  const StepGrid from_breakpoint = stepGridFrom(schedule.intervals()[32], {.step = 4e-3});
  EXPECT_EQ(from_breakpoint.count, 1u);
  EXPECT_WITHIN(2 * from_breakpoint.h, 0.0063, 1e-15);
  EXPECT_EQ(stepGridFrom(schedule.intervals()[33], {.step = 4e-3}).count, 268);  // 0.32 s .. 3 s
}

TEST(StepGrid, BreakpointOnASampleDividesIt) {
  const Input input = inputOf({sineOnsetRail(0.31)});
  const Schedule schedule(input, 0.01);
  EXPECT_EQ(stepGridFrom(schedule.intervals()[0], {}).count, 31);
  EXPECT_EQ(stepGridFrom(schedule.intervals()[31], {}).count, 269);
}

TEST(StepsOf, LengthAboveAMultipleByRoundingAloneCostsNoStepMore) {
  EXPECT_EQ(stepsOf(0.005, {.step = 0.001}), 5);
  EXPECT_EQ(stepsOf(std::nextafter(0.005, 1.0), {.step = 0.001}), 5);
  EXPECT_EQ(stepsOf(0.0050001, {.step = 0.001}), 6);
  EXPECT_EQ(stepsOf(1e-12, {.step = 0.001}), 1);
  EXPECT_EQ(stepsOf(0.005, {.step = 0.001, .refine = 4}), 20);
}

TEST(StepsOf, RefusesStepsThatAreNone) {
  EXPECT_THROW((void)stepsOf(1.0, {.step = 0.0}), std::invalid_argument);
  EXPECT_THROW((void)stepsOf(1.0, {.step = -1.0}), std::invalid_argument);
  EXPECT_THROW((void)stepsOf(1.0, {.step = std::nan("")}), std::invalid_argument);
  EXPECT_THROW((void)stepsOf(1.0, {.step = 1e-3, .refine = 0}), std::invalid_argument);
  try {
    (void)stepsOf(1.0, {.step = 1e-12});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "fixed step: 1 s in steps of 1e-12 s are 1e9 steps or more, must be fewer; choose a longer step");
  }
}

TEST(StateArray, RefusesASizeThatIsNone) {
  EXPECT_THROW(StateArray<kDynamicSize>(0), std::invalid_argument);
  EXPECT_THROW(StateArray<8>(4), std::invalid_argument);
  EXPECT_EQ(StateArray<8>(8).size(), 8);
}

}  // namespace
}  // namespace vehicle::test
