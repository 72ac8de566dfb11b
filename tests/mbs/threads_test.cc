// One Simbody System per thread: forms built and run side by side give the bits of a serial run.
#include <cmath>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/mbs/mbs_form.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

/// A form of its own, a run of Simbody's integrator and many evaluations; all states and derivatives met.
std::vector<double> work(MbsLaw law) {
  const auto form = buildMbsForm(compile(heightsVehicle(), 9.81), law);
  InputSegment rail;
  rail.begin = 0.0;
  rail.end = 0.5;
  rail.angular_frequency = {5.0};
  rail.cosine = {0.0, 1e-3, 2e-3, 3e-3};
  rail.sine = {5e-3, 4e-3, 5e-3, 4e-3};
  rail.polynomial.assign(16, 0.0);
  const Input input(4, {rail});
  std::vector<double> met, dx(8), u(8);
  const Schedule schedule(input, 0.01);
  const std::vector<double> rest(8, 0.0);
  form->bySimbody({*form, input, schedule, rest}, 1e-8)
      ->run(schedule, rest, [&](int, int segment, double t, std::span<const double> x) {
        met.insert(met.end(), x.begin(), x.end());
        input.evaluate(segment, t, u);
        form->derivative(x, u, dx);
        met.insert(met.end(), dx.begin(), dx.end());
        return true;
      });
  return met;
}

// Who computes changes, never the order inside a sum: equality is exact, not near.
TEST(MbsThreads, AFormOfItsOwnGivesEveryThreadTheBitsOfTheSerialRun) {
  for (const MbsLaw law : {MbsLaw::kLinear, MbsLaw::kTrue}) {
    const std::vector<double> serial = work(law);
    std::vector<std::vector<double>> met(3);
    std::vector<std::thread> threads;
    for (std::vector<double>& mine : met) threads.emplace_back([&mine, law] { mine = work(law); });
    for (std::thread& each : threads) each.join();
    for (const std::vector<double>& each : met) EXPECT_EQ(each, serial);
  }
}

}  // namespace
}  // namespace vehicle::test
