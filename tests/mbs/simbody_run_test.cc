// Simbody's own Runge-Kutta-Merson over a schedule: closed forms, conserved energy, and what must stop it.
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/mbs/mbs_form.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]
constexpr double kMass = 1000.0, kStiffness = 1e6, kDamping = 8e3;

Vehicle oneMass(double damping) {
  Vehicle made;
  made.name = "one-mass";
  made.elements = {element("spring", kStiffness, damping)};
  made.bodies = {body("mass", kMass, 0.0, std::nullopt, {Motion::kZ})};
  made.wheelsets = {wheelset("wheelset_1", 0.0)};
  made.suspensions = {suspension("spring_1", "spring", "mass", "wheelset_1", 0.0)};
  return made;
}

Statistics runSimbody(const MbsForm& form, const RunProblem& problem, double accuracy, const Observer& observe) {
  return form.bySimbody(problem, accuracy)->run(problem.schedule, problem.x0, observe);
}

InputSegment flat(int channels, double begin, double end, double height) {
  InputSegment made;
  made.begin = begin;
  made.end = end;
  made.polynomial.assign(4 * static_cast<std::size_t>(channels), 0.0);
  for (std::size_t i = 0; i < made.polynomial.size(); i += 4) made.polynomial[i] = height;
  return made;
}

/// eta = amplitude sin(w (t - begin)) on one channel
InputSegment sine(double begin, double end, double amplitude, double w) {
  InputSegment made = flat(1, begin, end, 0.0);
  made.angular_frequency = {w};
  made.cosine = {0.0};
  made.sine = {amplitude};
  return made;
}

/// m z'' + c (z' - eta') + k (z - eta) = 0 from (z0, v0) at s = 0 on eta = height + amplitude sin(w s): the
/// steady vibration plus a decaying one (any book on vibration).
struct BaseExcitedMass {
  double z, v;
  BaseExcitedMass(double z0, double v0, double height, double amplitude, double w, double s) {
    using Complex = std::complex<double>;
    const Complex j(0.0, 1.0);
    const Complex spring = kStiffness + j * w * kDamping;
    const Complex steady = amplitude * spring / (spring - kMass * w * w);
    const double decay = kDamping / (2.0 * kMass), natural = std::sqrt(kStiffness / kMass - decay * decay);
    const double free_z = z0 - height - steady.imag(), free_v = v0 - (j * w * steady).imag();
    const double b = (free_v + decay * free_z) / natural, e = std::exp(-decay * s);
    const double c = std::cos(natural * s), d = std::sin(natural * s);
    const Complex turning = steady * std::exp(j * w * s);
    z = height + turning.imag() + e * (free_z * c + b * d);
    v = (j * w * turning).imag() + e * ((-decay * free_z + natural * b) * c + (-decay * b - natural * free_z) * d);
  }
};

// Nothing, then half a sine of 20 ms between two output samples 50 ms apart, then nothing: both breakpoints lie between
// samples, and a step that saw past one would be wrong by far more than the tolerance. An integrator that is free
// to choose its first step goes over the whole bump.
TEST(SimbodyRun, BumpBetweenOutputSamplesHasTheClosedForm) {
  const double w = M_PI / 0.02, amplitude = 0.01, start = 0.113, end = start + 0.02;
  const Input input(1, {flat(1, 0.0, start, 0.0), sine(start, end, amplitude, w), flat(1, end, 3.0, 0.0)});
  const Schedule schedule(input, 0.05);
  const auto form = buildMbsForm(compile(oneMass(kDamping), kGravity), MbsLaw::kLinear);
  const BaseExcitedMass left(0.0, 0.0, 0.0, amplitude, w, 0.02);
  double worst = 0.0, peak = 0.0;
  int next = 0;
  const Statistics statistics =
      runSimbody(*form, {*form, input, schedule, std::vector<double>(2, 0.0)}, 1e-12,
                 [&](int sample, int, double t, std::span<const double> x) {
                   EXPECT_EQ(sample, next++);
                   EXPECT_WITHIN(t, schedule.time(sample), 0.0);
                   const double expected = t <= start ? 0.0 : BaseExcitedMass(left.z, left.v, 0.0, 0.0, w, t - end).z;
                   worst = std::max(worst, std::abs(x[0] - expected));
                   peak = std::max(peak, std::abs(expected));
                   return true;
                 });
  EXPECT_EQ(next, schedule.samples());
  EXPECT_GT(peak, 1e-3);
  // The integrator's own error: 1e-12 a step on the scale of 1 m, adding up over some ten steps of a damped motion
  // (seen: 1.2e-11 m). A step across one of the breakpoints would err by 1e-6 m.
  EXPECT_WITHIN(worst, 0.0, 5e-11);
  EXPECT_GT(statistics.steps, 60);
  EXPECT_GT(statistics.evaluations, 4 * statistics.steps);
  EXPECT_FALSE(statistics.stopped);
}

// An accuracy so loose that every step of 1 ms is taken: what is left is order 4 at w h = 0.16, about 1e-9 m here. A
// step that began with the derivative from before the breakpoint would be off by (c eta'/m) h/6 = 2 mm/s, 1e-5 m, and only
// a tight accuracy would hide it behind rejected steps.
TEST(SimbodyRun, TheStepAfterABreakpointStartsFromTheRightHandLimit) {
  const double w = M_PI / 0.02, amplitude = 0.01, start = 0.1135, end = start + 0.02;
  const Input input(1, {flat(1, 0.0, start, 0.0), sine(start, end, amplitude, w), flat(1, end, 0.5, 0.0)});
  const auto form = buildMbsForm(compile(oneMass(kDamping), kGravity), MbsLaw::kLinear);
  const BaseExcitedMass left(0.0, 0.0, 0.0, amplitude, w, 0.02);
  double worst = 0.0;
  const std::vector<double> x0(2, 0.0);
  const Statistics statistics = runSimbody(*form, {*form, input, Schedule(input, 1e-3), x0}, 0.9,
                                           [&](int, int, double t, std::span<const double> x) {
                                             double expected = 0.0;
                                             if (t > start)
                                               expected = BaseExcitedMass(0.0, 0.0, 0.0, amplitude, w, t - start).z;
                                             if (t > end)
                                               expected = BaseExcitedMass(left.z, left.v, 0.0, 0.0, w, t - end).z;
                                             worst = std::max(worst, std::abs(x[0] - expected));
                                             return true;
                                           });
  EXPECT_EQ(statistics.rejected, 0);
  EXPECT_EQ(statistics.steps, 502);  // 500 between samples, one more for each breakpoint
  EXPECT_WITHIN(worst, 0.0, 5e-8);
}

// On a breakpoint that is an output sample the observer gets the segment that begins there.
TEST(SimbodyRun, SampleOnABreakpointBelongsToTheSegmentThatBegins) {
  const Input input(1, {flat(1, 0.0, 0.1, 0.0), sine(0.1, 0.3, 0.01, 5.0)});
  const auto form = buildMbsForm(compile(oneMass(kDamping), kGravity), MbsLaw::kLinear);
  std::vector<int> segments;
  runSimbody(*form, {*form, input, Schedule(input, 0.05), std::vector<double>(2, 0.0)}, 1e-9,
             [&](int, int segment, double, std::span<const double>) {
               segments.push_back(segment);
               return true;
             });
  EXPECT_EQ(segments, (std::vector<int>{0, 0, 1, 1, 1, 1, 1}));
}

// Asking for columns between two samples uses the same Simbody System and must leave no trace in the run.
TEST(SimbodyRun, AskingForColumnsOnTheWayChangesNoBit) {
  const Input input(1, {flat(1, 0.0, 0.08, 0.0), sine(0.08, 1.0, 0.01, 12.0)});
  const Schedule schedule(input, 0.05);
  const auto form = buildMbsForm(compile(oneMass(kDamping), kGravity), MbsLaw::kTrue);
  const auto last = [&](bool ask) {
    std::vector<double> reached, u(3), y(form->outputs().size());
    runSimbody(*form, {*form, input, schedule, std::vector<double>(2, 0.0)}, 1e-9,
               [&](int, int segment, double t, std::span<const double> x) {
                 if (ask) {
                   input.evaluate(segment, t, u);
                   form->output(x, u, y);
                 }
                 reached.assign(x.begin(), x.end());
                 return true;
               });
    return reached;
  };
  EXPECT_EQ(last(false), last(true));
}

/// Stored and kinetic energy of a vehicle that stands on flat rail [J], heights and gravity included.
double energyOf(const std::vector<double>& x) {
  const double mk = 57e3, jk = 70e3, mb = 9e3, ak = 3.725, ck = 2660e3, cb = 3040e3, h = -0.5;
  const double on_secondary = mk * kGravity / 2.0, on_primary = (mk / 2.0 + mb) * kGravity / 2.0;
  double energy = 0.5 * (mk * x[4] * x[4] + jk * x[5] * x[5] + mb * (x[6] * x[6] + x[7] * x[7])) +
                  kGravity * (mk * x[0] + mb * (x[2] + x[3]));
  const double side[] = {1.0, -1.0};
  for (std::size_t i = 0; i < 2; ++i) {
    const double bogie = x[2 + i];
    const double d = x[0] + side[i] * ak * std::sin(x[1]) + h * (std::cos(x[1]) - 1.0) - bogie;
    energy += 0.5 * ck * d * d - on_secondary * d + 2.0 * (0.5 * cb * bogie * bogie - on_primary * bogie);
  }
  return energy;
}

// Without dampers nothing is lost at any angle: gravity, preload and the true attachment points together must have
// a potential. 5 s are seven periods of the bounce.
TEST(SimbodyRun, UndampedVehicleKeepsItsEnergyAtLargeAngles) {
  Vehicle made = heightsVehicle(0.5);
  for (Element& each : made.elements) each.damping_z = 0.0;
  const auto form = buildMbsForm(compile(made, kGravity), MbsLaw::kTrue);
  const Input input(4, {flat(4, 0.0, 5.0, 0.0)});
  const std::vector<double> x0 = {0.02, 0.15, -0.01, 0.005, 0.1, 0.0, 0.0, 0.2};
  const double stored = energyOf(x0);
  double worst = 0.0, turned = 0.0;
  runSimbody(*form, {*form, input, Schedule(input, 0.05), x0}, 1e-10, [&](int, int, double, std::span<const double> x) {
    worst = std::max(worst, std::abs(energyOf({x.begin(), x.end()}) - stored));
    turned = std::max(turned, std::abs(x[1] - x0[1]));
    return true;
  });
  EXPECT_GT(turned, 0.2);
  // The integrator's error: 1e-10 a step over 1e4 steps; a force that is no gradient shows above 1e-3.
  EXPECT_WITHIN(worst, 0.0, 1e-7 * stored);
}

TEST(SimbodyRun, TighterAccuracyTakesMoreSteps) {
  const Input input(1, {sine(0.0, 2.0, 0.01, 12.0)});
  const auto form = buildMbsForm(compile(oneMass(kDamping), kGravity), MbsLaw::kLinear);
  const auto steps = [&](double accuracy) {
    return runSimbody(*form, {*form, input, Schedule(input, 0.5), std::vector<double>(2, 0.0)}, accuracy,
                      [](int, int, double, std::span<const double>) { return true; })
        .steps;
  };
  EXPECT_GT(steps(1e-10), 2 * steps(1e-6));
}

TEST(SimbodyRun, AnObserverEndsTheRun) {
  const Input input(1, {flat(1, 0.0, 1.0, 0.0)});
  const auto form = buildMbsForm(compile(oneMass(kDamping), kGravity), MbsLaw::kLinear);
  int seen = 0;
  const auto until = [&](int last) {
    seen = 0;
    return runSimbody(*form, {*form, input, Schedule(input, 0.1), std::vector<double>(2, 0.0)}, 1e-6,
                      [&](int sample, int, double, std::span<const double>) {
                        ++seen;
                        return sample < last;
                      });
  };
  EXPECT_TRUE(until(3).stopped);
  EXPECT_EQ(seen, 4);
  EXPECT_TRUE(until(0).stopped);
  EXPECT_EQ(seen, 1);
}

TEST(SimbodyRun, AnObserversExceptionPassesUntouched) {
  const Input input(1, {flat(1, 0.0, 1.0, 0.0)});
  const auto form = buildMbsForm(compile(oneMass(kDamping), kGravity), MbsLaw::kLinear);
  const auto run = [&] {
    runSimbody(*form, {*form, input, Schedule(input, 0.1), std::vector<double>(2, 0.0)}, 1e-6,
               [](int, int, double, std::span<const double>) -> bool { throw std::out_of_range("disk"); });
  };
  EXPECT_THROW(run(), std::out_of_range);
}

/// What a run says when it fails.
std::string failureOf(const MbsForm& form, const Input& input, const std::vector<double>& x0) {
  try {
    runSimbody(form, {form, input, Schedule(input, 0.1), x0}, 1e-6,
               [](int, int, double, std::span<const double>) { return true; });
  } catch (const RunFailed& failure) {
    return failure.what();
  }
  return "nothing";
}

TEST(SimbodyRun, NotANumberIsNamedWithItsTime) {
  const Input input(1, {flat(1, 0.0, 1.0, 0.0)});
  const auto form = buildMbsForm(compile(oneMass(kDamping), kGravity), MbsLaw::kLinear);
  EXPECT_EQ(failureOf(*form, input, {0.0, std::numeric_limits<double>::quiet_NaN()}),
            "simbody_rkm: mass.vz is nan at t = 0 s");
}

// Finite at the start, beyond every number soon after: Simbody gives up or returns what is no number.
TEST(SimbodyRun, AnExplodingMotionFailsWithTheTimeReached) {
  const Input input(1, {flat(1, 0.0, 1.0, 0.0)});
  const auto form = buildMbsForm(compile(oneMass(kDamping), kGravity), MbsLaw::kLinear);
  const std::string said = failureOf(*form, input, {1e308, 1e308});
  EXPECT_EQ(said.substr(0, 13), "simbody_rkm: ") << said;
  EXPECT_NE(said.find("t = 0"), std::string::npos) << said;
}

TEST(SimbodyRun, WrongArgumentsAreNamed) {
  const Input input(1, {flat(1, 0.0, 1.0, 0.0)});
  const auto form = buildMbsForm(compile(oneMass(kDamping), kGravity), MbsLaw::kLinear);
  const auto said = [&](const Input& rail, double accuracy, std::size_t size) -> std::string {
    try {
      runSimbody(*form, {*form, rail, Schedule(rail, 0.1), std::vector<double>(size, 0.0)}, accuracy,
                 [](int, int, double, std::span<const double>) { return true; });
    } catch (const std::invalid_argument& wrong) {
      return wrong.what();
    }
    return "nothing";
  };
  EXPECT_EQ(said(input, 0.0, 2), "simbody_rkm: accuracy = 0, must be > 0 and < 1");
  EXPECT_EQ(said(input, std::numeric_limits<double>::quiet_NaN(), 2),
            "simbody_rkm: accuracy = nan, must be > 0 and < 1");
  EXPECT_EQ(said(input, 1e-6, 3), "simbody_rkm: the initial state has 3 numbers, must be 2");
  EXPECT_EQ(said(Input(2, {flat(2, 0.0, 1.0, 0.0)}), 1e-6, 2), "simbody_rkm: the input has 2 wheelsets, must be 1");
}

}  // namespace
}  // namespace vehicle::test
