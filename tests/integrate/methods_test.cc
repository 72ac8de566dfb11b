#include <limits>
#include <stdexcept>

#include "tests/integrate/cases.h"
#include "tests/support/allocations.h"
#include "tests/support/refusal.h"
#include "tests/support/tolerance.h"

// What every method owes, whatever it is called. A new method adds one struct here.
namespace vehicle::test {
namespace {

struct ByRk4 {
  static constexpr const char* kName = "rk4";
  // At 1 ms and w h <= 0.02 the global error of order 4 is about (w h)^4 / 120 x w T: 1e-8 of the peak.
  static constexpr double kError = 2e-8;
  // Undamped, rk4 loses (w h)^6 / 72 of the energy a step: 2e-12 x 3000 steps at w h = 8 ms.
  static constexpr double kEnergyError = 1e-9;
  static constexpr double kRestartError = 1e-15;  // the same steps; only the phases of the rail round differently
  static Statistics run(const System& s, const Input& i, const Schedule& g, States x, const Observer& o) {
    return runRk4({s, i, g, x}, {.step = 1e-3}, o);
  }
};

struct ByDopri5 {
  static constexpr const char* kName = "dopri5";
  static constexpr double kError = 1e-8;  // what rtol 1e-10, atol 1e-12 m promises at amplitudes of mm and mm/s
  static constexpr double kEnergyError = 1e-8;
  static constexpr double kRestartError = 1e-8;  // other steps
  static Statistics run(const System& s, const Input& i, const Schedule& g, States x, const Observer& o) {
    return runDopri5({s, i, g, x}, {.relative = 1e-10, .absolute = 1e-12}, o);
  }
};

struct ByExact {
  static constexpr const char* kName = "exact";
  static constexpr double kError = 1e-13;  // rounding only
  static constexpr double kEnergyError = 2e-13;
  static constexpr double kRestartError = 1e-13;
  static Statistics run(const System& s, const Input& i, const Schedule& g, States x, const Observer& o) {
    return runExact({s, i, g, x}, o);
  }
};

template <class Method>
class EveryMethod : public ::testing::Test {};
using Methods = ::testing::Types<ByRk4, ByDopri5, ByExact>;
struct MethodNames {
  template <class Method>
  static std::string GetName(int) {
    return Method::kName;
  }
};
TYPED_TEST_SUITE(EveryMethod, Methods, MethodNames);

const Observer kIgnore = [](int, int, double, std::span<const double>) { return true; };

TYPED_TEST(EveryMethod, RestOnFlatRailStaysAtRest) {
  const Case problem = caseOf("rest", bounce(), flatRail());
  int samples = 0;
  TypeParam::run(problem.system, problem.input, Schedule(problem.input, 0.01), problem.start,
                 [&](int, int, double, std::span<const double> x) {
                   ++samples;
                   EXPECT_EQ(x[0], 0.0);
                   EXPECT_EQ(x[1], 0.0);
                   return true;
                 });
  EXPECT_EQ(samples, 301);
}

TYPED_TEST(EveryMethod, FollowsTheClosedFormWithinAndAcrossBreakpoints) {
  for (const Case& problem : allCases()) {
    EXPECT_WITHIN(worstError(problem, 0.01, TypeParam::run), 0.0, TypeParam::kError) << problem.name;
  }
}

// x' = eta, eta a cubic: x is a quartic. Simpson's rule, which rk4 then is, is exact for a cubic.
TYPED_TEST(EveryMethod, IntegratesACubicExactly) {
  const MatrixSystem integrator({Eigen::MatrixXd::Zero(1, 1), Eigen::RowVector2d(1.0, 0.0)});
  InputSegment segment{.begin = 2.0, .end = 4.0, .angular_frequency = {}, .cosine = {}, .sine = {},
                       .polynomial = {0.3, -0.7, 0.9, 0.2}, .sampled = {}};
  const Input input(1, {segment});
  const std::vector<double> start = {0.25};
  TypeParam::run(integrator, input, Schedule(input, 0.5), start, [](int, int, double t, std::span<const double> x) {
    const double s = t - 2.0;
    // 500 steps a sample add 500 roundings of numbers near one.
    EXPECT_WITHIN(x[0], 0.25 + s * (0.3 + s * (-0.35 + s * (0.3 + s * 0.05))), 1e-13) << t;
    return true;
  });
}

TYPED_TEST(EveryMethod, ShowsEverySampleOnceInOrderWithTheSegmentToItsRight) {
  // The second breakpoint, 0.47 s, is sample 47.
  const double w = std::acos(-1.0) / (0.47 - 0.3137);
  const std::vector<RailPiece> rail = {
      {0.0, 0.3137, 0.0, 0.0, {}}, {0.3137, 0.47, 0.0, 0.0, {{w, {0.0, 0.01}}}}, {0.47, 3.0, 0.0, 0.0, {}}};
  const Case problem = caseOf("dip", bounce(), rail);
  const Schedule schedule(problem.input, 0.01);
  int next = 0;
  TypeParam::run(problem.system, problem.input, schedule, problem.start,
                 [&](int sample, int segment, double t, std::span<const double> x) {
                   EXPECT_EQ(sample, next++);
                   // The breakpoint is said as 0.47 s, the sample as 47 x 0.01 s: one rounding apart.
                   EXPECT_WITHIN(t, schedule.time(sample), 1e-15);
                   EXPECT_EQ(segment, t < 0.3137 ? 0 : sample < 47 ? 1 : 2) << sample;
                   EXPECT_EQ(x.size(), 2u);
                   return true;
                 });
  EXPECT_EQ(next, schedule.samples());
}

TYPED_TEST(EveryMethod, AnObserverCanEndTheRun) {
  const Case problem = caseOf("onset", bounce(), sineOnsetRail());
  for (const int last : {0, 1, 40}) {
    int seen = -1;
    const Statistics statistics =
        TypeParam::run(problem.system, problem.input, Schedule(problem.input, 0.01), problem.start,
                       [&](int sample, int, double, std::span<const double>) {
                         seen = sample;
                         return sample < last;
                       });
    EXPECT_EQ(seen, last);
    EXPECT_TRUE(statistics.stopped);
  }
  const Schedule schedule(problem.input, 0.01);
  EXPECT_FALSE(TypeParam::run(problem.system, problem.input, schedule, problem.start, kIgnore).stopped);
}

TYPED_TEST(EveryMethod, AnUndampedMassKeepsItsEnergy) {
  DrivenMass mass = bounce();
  mass.damping = mass.rail_damping = 0.0;
  const Case problem = caseOf("undamped", mass, flatRail(), {0.01, 0.05});
  const double before = mass.energy({0.01, 0.05});
  TypeParam::run(problem.system, problem.input, Schedule(problem.input, 0.01), problem.start,
                 [&](int, int, double, std::span<const double> x) {
                   EXPECT_WITHIN(mass.energy({x[0], x[1]}) / before, 1.0, TypeParam::kEnergyError);
                   return true;
                 });
}

TYPED_TEST(EveryMethod, StoredAndDissipatedEnergyAddUp) {
  const DrivenMass mass = bounce();
  const Case problem = caseOf("decay", mass, flatRail(2.0), {0.01, 0.05});
  std::vector<double> power, stored;
  TypeParam::run(problem.system, problem.input, Schedule(problem.input, 1e-3), problem.start,
                 [&](int, int, double, std::span<const double> x) {
                   power.push_back(mass.damping * x[1] * x[1]);
                   stored.push_back(mass.energy({x[0], x[1]}));
                   return true;
                 });
  double dissipated = 0.0;
  // Simpson over 1 ms samples of a power that swings at 16 rad/s: (16 h)^4 / 180 = 4e-10 of the whole.
  for (std::size_t i = 0; i + 2 < power.size(); i += 2) {
    dissipated += 1e-3 / 3.0 * (power[i] + 4.0 * power[i + 1] + power[i + 2]);
  }
  EXPECT_GT(dissipated, 0.9 * stored.front());
  EXPECT_WITHIN((stored.back() + dissipated) / stored.front(), 1.0, 1e-9 + TypeParam::kEnergyError);
}

// Time-invariance: the second half alone, on its own clock, from where the first half arrived.
TYPED_TEST(EveryMethod, TwoHalvesMakeOneRun) {
  const Case whole = caseOf("sine", bounce(), sineRail(2.0), {0.002, 0.01});
  std::vector<double> x(2), end(2);
  const auto keep = [](std::vector<double>& into) {
    return [&into](int, int, double, std::span<const double> state) {
      into.assign(state.begin(), state.end());
      return true;
    };
  };
  TypeParam::run(whole.system, whole.input, Schedule(whole.input, 0.01), whole.start, keep(end));
  const Case first = caseOf("first half", bounce(), sineRail(1.0), {0.002, 0.01});
  TypeParam::run(first.system, first.input, Schedule(first.input, 0.01), first.start, keep(x));
  std::vector<RailPiece> shifted = sineRail(1.0);
  for (RailPiece::Wave& wave : shifted[0].waves) wave.amplitude *= std::polar(1.0, wave.angular_frequency);
  const Case second = caseOf("second half", bounce(), shifted);
  const std::vector<double> middle = x;
  TypeParam::run(second.system, second.input, Schedule(second.input, 0.01), middle, keep(x));
  EXPECT_WITHIN(x[0], end[0], TypeParam::kRestartError * 0.01);  // 10 mm, 0.1 m/s: the peaks
  EXPECT_WITHIN(x[1], end[1], TypeParam::kRestartError * 0.1);
}

TYPED_TEST(EveryMethod, TakesNoMemoryWhileItSteps) {
  const Case problem = caseOf("sine", bounce(), sineRail(), {0.002, 0.01});
  long early = 0, late = 0;
  TypeParam::run(problem.system, problem.input, Schedule(problem.input, 0.01), problem.start,
                 [&](int sample, int, double, std::span<const double>) {
                   (sample <= 2 ? early : late) = allocations();
                   return true;
                 });
  EXPECT_GT(early, 0);
  EXPECT_EQ(late, early);
}

TYPED_TEST(EveryMethod, SystemThatOutgrowsTheNumbersIsAnErrorWithTheTime) {
  // x' = 2000 x passes 1e308 at t = 0.355 s; in 1 ms steps of rk4, which grow by 7 each, at 0.365 s.
  const MatrixSystem runaway({Eigen::MatrixXd::Constant(1, 1, 2000.0), Eigen::RowVector2d(0.0, 0.0)});
  const Input input = caseOf("flat", bounce(), flatRail(1.0)).input;
  const std::vector<double> start = {1.0};
  double reached = 0.0;
  try {
    TypeParam::run(runaway, input, Schedule(input, 0.01), start, [&](int, int, double t, std::span<const double> x) {
      reached = t;
      EXPECT_TRUE(std::isfinite(x[0]));
      return true;
    });
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.rfind(std::string(TypeParam::kName) + ": ", 0), 0u) << text;
    EXPECT_NE(text.find("finite"), std::string::npos) << text;
    EXPECT_NE(text.find(" at t = 0.3"), std::string::npos) << text;
  }
  EXPECT_GT(reached, 0.3);
  EXPECT_LT(reached, 0.4);
}

TYPED_TEST(EveryMethod, RefusesAStartOrAnInputThatDoesNotFit) {
  const Case problem = caseOf("flat", bounce(), flatRail());
  const Schedule schedule(problem.input, 0.01);
  const auto messageOf = [&](const Input& input, const std::vector<double>& start) {
    return refusalOf([&] { TypeParam::run(problem.system, input, schedule, start, kIgnore); });
  };
  const std::string name = TypeParam::kName;
  EXPECT_EQ(messageOf(problem.input, {1.0}), name + ": x0 has 1 values, must have 2, one a state");
  EXPECT_EQ(messageOf(problem.input, {1.0, std::nan("")}), name + ": x0[1] = nan, must be finite");
  EXPECT_EQ(messageOf(twoMassesOnOnset().input, {0.0, 0.0}),
            name + ": the input has 2 channels, must have 1, one a wheelset of the system");
}

template <class Method>
class StageMethods : public ::testing::Test {};
using Stages = ::testing::Types<ByRk4, ByDopri5>;
TYPED_TEST_SUITE(StageMethods, Stages, MethodNames);

// A right-hand side that breaks at x > 0.5, from NaN or from a division by zero.
TYPED_TEST(StageMethods, NanOrInfiniteSlopesAreAnErrorWithTheTimeReached) {
  for (const double broken : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const ExpressionSystem ramp(
        1, 1, [=](const double* x, const double*, double* dx) { dx[0] = x[0] > 0.5 ? broken : 1.0; });
    const Input input = caseOf("flat", bounce(), flatRail(1.0)).input;
    const std::vector<double> start = {0.0};
    try {
      TypeParam::run(ramp, input, Schedule(input, 0.1), start, kIgnore);
      FAIL() << "no error";
    } catch (const std::runtime_error& error) {
      const std::string text = error.what();
      const std::size_t at = text.find(" at t = ");
      ASSERT_NE(at, std::string::npos) << text;
      // rk4 looks once a block, at most one sample later.
      const double t = std::stod(text.substr(at + 8));
      EXPECT_GE(t, 0.499) << text;
      EXPECT_LE(t, 0.6001) << text;
    }
  }
}

}  // namespace
}  // namespace vehicle::test
