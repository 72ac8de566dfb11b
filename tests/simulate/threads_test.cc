// What may be shared between threads and what may not: the linear forms are built once and serve every thread;
// a run through Simbody builds its own System. Run it under the thread sanitizer.

#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/model/topology.h"
#include "libvehicle/simulate/simulate.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;
constexpr int kThreads = 3;

Scenario shortScenario() {
  Scenario scenario = paperScenario(History::kOnset);
  scenario.run.duration = 1.0;  // all four wheels have passed their breakpoints
  return scenario;
}

/// All states and columns of a run on a form that others are using at the same time.
std::vector<double> trace(const System& form, const Input& input, bool exact) {
  std::vector<double> met;
  std::vector<double> u(12);
  std::vector<double> y(form.outputs().size());
  const std::vector<double> rest(8, 0.0);
  const Schedule schedule(input, 0.005);
  const Observer observe = [&](int, int segment, double t, std::span<const double> x) {
    input.evaluate(segment, t, u);
    form.output(x, u, y);
    met.insert(met.end(), x.begin(), x.end());
    met.insert(met.end(), y.begin(), y.end());
    return true;
  };
  if (exact) {
    runExact({form, input, schedule, rest}, observe);
  } else {
    runRk4({form, input, schedule, rest}, FixedStep{}, observe);
  }
  return met;
}

// Who computes changes, never the order inside a sum: equality is exact, not near.
TEST(Threads, OneLinearFormServesAllWithTheBitsOfTheSerialRun) {
  const Vehicle vehicle = paperVehicle();
  const Input input = inputOf(shortScenario(), topologyOf(vehicle), 20.0);
  for (const char* name : {"flat", "matrix", "flat-7-printed"}) {
    const auto form = buildForm(name, compile(vehicle, kGravity));
    for (const bool exact : {false, true}) {
      const std::vector<double> serial = trace(*form, input, exact);
      std::vector<std::vector<double>> met(kThreads);
      std::vector<std::thread> threads;
      for (auto& mine : met) threads.emplace_back([&, exact] { mine = trace(*form, input, exact); });
      for (std::thread& each : threads) each.join();
      for (const auto& each : met) EXPECT_EQ(each, serial) << name << (exact ? ", exact" : ", rk4");
    }
  }
}

TEST(Threads, WholeRunsSideBySideGiveTheBitsOfTheSerialRun) {
  const Vehicle vehicle = paperVehicle();
  const Scenario scenario = shortScenario();
  for (const char* form : {"flat", "mbs"}) {
    RunChoice choice;
    choice.form = form;
    choice.method = "dopri5";
    const auto run = [&] { return simulate(vehicle, scenario, choice).history; };
    const TimeHistory serial = run();
    std::vector<TimeHistory> met(kThreads);
    std::vector<std::thread> threads;
    for (TimeHistory& mine : met) threads.emplace_back([&] { mine = run(); });
    for (std::thread& each : threads) each.join();
    for (const TimeHistory& each : met) {
      ASSERT_EQ(each.samples(), serial.samples());
      for (std::size_t column = 0; column < serial.columns().size(); ++column) {
        EXPECT_EQ(each.column(column), serial.column(column)) << form << ": " << serial.columns()[column].name;
      }
    }
  }
}

}  // namespace
}  // namespace vehicle::test
