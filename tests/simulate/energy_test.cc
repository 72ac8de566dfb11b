// Energy balance: what the rail puts in is stored or dissipated.

#include <gtest/gtest.h>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/model/rest.h"
#include "libvehicle/model/topology.h"
#include "tests/simulate/histories.h"
#include "tests/support/tolerance.h"
#include "tests/support/trains.h"

namespace vehicle::test {
namespace {

// Boole's rule on four equal intervals a panel, error ~ (lambda dt)^6.
double integral(const std::vector<double>& f, double dt) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 4 < f.size(); i += 4) {
    sum += 7 * f[i] + 32 * f[i + 1] + 12 * f[i + 2] + 32 * f[i + 3] + 7 * f[i + 4];
  }
  return sum * 2.0 * dt / 45.0;
}

struct Balance {
  double input = 0.0;       // [J] work of the rail over the run
  double stored = 0.0;      // [J] at the end, minus that at the start
  double dissipated = 0.0;  // [J]
};

Balance balanceOf(const Vehicle& vehicle, const Scenario& scenario, const std::string& form) {
  const Topology topology = topologyOf(vehicle);
  const Rest rest = restOf(topology, scenario.gravity);
  const Input input = inputOf(scenario, topology, scenario.run.speed);
  const TimeHistory history = run(vehicle, scenario, form, "exact").history;
  const std::size_t samples = history.samples();
  const double dt = scenario.run.output_step;

  std::vector<double> inputPower(samples, 0.0), lossPower(samples, 0.0), stored(samples, 0.0);
  std::vector<double> u(2 * topology.wheelsets.size());
  for (const TopologySuspension& each : topology.suspensions) {
    const std::vector<double> deflection = history.column(each.name + ".deflection");
    const std::vector<double> force = history.column(each.name + ".force");
    for (std::size_t i = 0; i < samples; ++i) {
      const double damper = force[i] - each.stiffness * deflection[i];
      lossPower[i] += damper * damper / each.damping;
      stored[i] += 0.5 * each.stiffness * deflection[i] * deflection[i];
      if (each.lower_wheelset >= 0) {
        input.evaluate(0, history.at(i, 0), u);
        inputPower[i] -= force[i] * u[topology.wheelsets.size() + static_cast<std::size_t>(each.lower_wheelset)];
      }
    }
  }
  for (std::size_t b = 0; b < topology.bodies.size(); ++b) {
    const TopologyBody& body = topology.bodies[b];
    const std::vector<double> vz = history.column(body.name + ".vz");
    for (std::size_t i = 0; i < samples; ++i) stored[i] += 0.5 * body.mass * vz[i] * vz[i];
    if (body.pitch_index < 0) continue;
    const std::vector<double> rate = history.column(body.name + ".pitch_rate");
    const std::vector<double> pitch = history.column(body.name + ".pitch");
    for (std::size_t i = 0; i < samples; ++i) {
      stored[i] += 0.5 * body.pitch_inertia * rate[i] * rate[i] + 0.5 * rest.pitch_stiffness[b] * pitch[i] * pitch[i];
    }
  }
  return {integral(inputPower, dt), stored.back() - stored.front(), integral(lossPower, dt)};
}

// 0.25 ms and |lambda| below 80 leave (0.02)^6 to the quadrature, the exact method 1e-13: 1e-9 of the input work
// is a thousand times either; a sign error anywhere is of order 1.
TEST(EnergyBalance, InputWorkIsStoredOrDissipatedOverTenSeconds) {
  for (const Vehicle& vehicle : {paperVehicle(), asymmetricVehicle(), heightsVehicle(), bogiePitchVehicle(),
                                 asymmetricBogiePitchVehicle(), bogiePitchHeightsVehicle(), assembled(mixedTrain()),
                                 assembled(equalTrain(bogiePitchVehicle(), 2, 26.0))}) {
    for (const char* form : {"flat", "matrix", "mbs-linear"}) {
      if (!formUnsupported(form, topologyOf(vehicle)).empty()) continue;
      Scenario scenario = paperScenario(History::kExtended);
      scenario.run.output_step = 0.25e-3;
      const Balance balance = balanceOf(vehicle, scenario, form);
      EXPECT_GT(balance.dissipated, 1.0) << "nothing happened";
      EXPECT_WITHIN((balance.stored + balance.dissipated) / balance.input, 1.0, 1e-9) << vehicle.name << " " << form;
    }
  }
}

}  // namespace
}  // namespace vehicle::test
