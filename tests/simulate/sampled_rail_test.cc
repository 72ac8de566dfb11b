// Runs over a rail that is known by samples, against the rail that they were taken from.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/partition/run.h"
#include "libvehicle/simulate/forms.h"
#include "libvehicle/track/rail_piece.h"
#include "tests/support/refusal.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

constexpr double kSpeed = 20.0, kEnd = 5.0, kWave = 2.0 * std::numbers::pi / 10.0, kAmplitude = 2e-3;

std::vector<RailPiece> harmonicRail() {
  RailPiece wave;
  wave.from = -INFINITY;
  wave.to = INFINITY;
  wave.waves = {{kWave, 0.0, kAmplitude}};
  return {wave};
}

std::vector<RailPiece> sampledRail(double spacing) {
  constexpr double kBegin = -50.0;
  std::vector<double> heights(static_cast<std::size_t>(200.0 / spacing));
  for (std::size_t i = 0; i < heights.size(); ++i) {
    heights[i] = kAmplitude * std::sin(kWave * (kBegin + static_cast<double>(i) * spacing));
  }
  return piecesOf(std::make_shared<SampledRail>(std::make_shared<StoredSamples>(std::move(heights)),
                                                SampleGridOverDistance{kBegin, spacing}));
}

/// The paper's vehicle at rest on such a rail, and the states of a run of it every 5 ms.
struct Case {
  CompiledModel model = compile(paperVehicle(), 9.81);
  std::unique_ptr<System> system = buildForm("matrix", model);
  Input input;
  Schedule schedule;
  std::vector<double> x0 = std::vector<double>(static_cast<std::size_t>(system->size()), 0.0);

  explicit Case(const std::vector<RailPiece>& rail, const Travel& travel = Travel(kSpeed))
      : input(inputOf(rail, model.topology, travel, {kEnd, 5e-3})), schedule(input, 5e-3) {}

  [[nodiscard]] RunProblem problem() const { return {*system, input, schedule, x0}; }

  template <class Run>
  std::vector<double> statesOf(const Run& run) const {
    std::vector<double> states;
    const Observer keep = [&](int, int, double, std::span<const double> x) {
      states.insert(states.end(), x.begin(), x.end());
      return true;
    };
    run(*this, keep);
    return states;
  }
};

std::vector<double> byRk4(const Case& of) {
  return of.statesOf([](const Case& c, const Observer& keep) { (void)runRk4(c.problem(), {1e-3}, keep); });
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// Rates of the states are up to a k V = 25 mm/s. The spline's slope errs by (k d)^3 / 125 of the rail's, 3e-5 at 0.25 m, and
// swings so fast that the vehicle follows little of it; half the spacing divides that by 8 at least.
TEST(SampledRail, ARunOverSamplesIsThatOverTheirRail) {
  const std::vector<double> truth = byRk4(Case(harmonicRail()));
  const double coarse = largestDifference(byRk4(Case(sampledRail(0.25))), truth);
  const double fine = largestDifference(byRk4(Case(sampledRail(0.125))), truth);
  EXPECT_LT(coarse, 3e-5 * 25e-3);
  EXPECT_GT(coarse / fine, 7.5);
}

// Tolerances of 1e-10 against rk4's 1 ms: (60 rad/s 1e-3)^4 / 120 of 25 mm/s, 3e-9.
TEST(SampledRail, Dopri5AgreesWithRk4OnTheSameSamples) {
  const Case sampled(sampledRail(0.25));
  const std::vector<double> adaptive = sampled.statesOf([](const Case& c, const Observer& keep) {
    (void)runDopri5(c.problem(), {1e-10, 1e-12}, keep);
  });
  EXPECT_LT(largestDifference(adaptive, byRk4(sampled)), 1e-8);
}

TEST(SampledRail, ThreadsGiveTheBitsOfOne) {
  const Case sampled(sampledRail(0.25));
  const std::vector<double> alone = byRk4(sampled);
  for (const Scheme scheme : {Scheme::kStages, Scheme::kHalo, Scheme::kPipeline}) {
    const std::vector<double> shared = sampled.statesOf([&](const Case& c, const Observer& keep) {
      (void)runPartitioned(c.problem(), {1e-3}, keep, {.threads = 2, .scheme = scheme}, {});
    });
    EXPECT_TRUE(shared == alone) << nameOf(scheme);
  }
}

TEST(SampledRail, ExactRefusesWhatHasNoClosedForm) {
  const auto exact = [](const Case& of) {
    return refusalOf([&] { (void)runExact(of.problem(), [](auto&&...) { return true; }); });
  };
  EXPECT_EQ(exact(Case(harmonicRail())), "accepted");
  EXPECT_EQ(
      exact(Case(sampledRail(0.25))),
      "exact: the rail from t = 0 s on is known by samples, or passed at a changing speed, and has no closed form; "
      "take rk4 or dopri5");
  const Travel braking(kSpeed, std::vector<Travel::Phase>{{2.0, -1.0}});
  EXPECT_NE(exact(Case(harmonicRail(), braking)), "accepted");
}

// At constant speed after all: phases without acceleration give the functions of time, not the closed form, and the run of the
// closed form to the rounding of its phases, 1e-14 of 25 mm/s a step.
TEST(ChangingSpeed, WithoutAccelerationIsTheConstantSpeed) {
  const Travel phased(kSpeed, std::vector<Travel::Phase>{{2.0, 0.0}});
  ASSERT_FALSE(phased.isUniform());
  EXPECT_LT(largestDifference(byRk4(Case(harmonicRail(), phased)), byRk4(Case(harmonicRail()))), 1e-13);
}

}  // namespace
}  // namespace vehicle::test
