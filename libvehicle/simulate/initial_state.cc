#include "libvehicle/simulate/initial_state.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/LU>
#include <fmt/format.h>

#include "libvehicle/linear/motion_rates.h"
#include "libvehicle/linear/steady_state.h"
#include "libvehicle/matrix/matrix_form.h"

namespace vehicle {

namespace {

[[noreturn]] void refuse(const Scenario& scenario, std::string message, std::string remedy) {
  ProblemList problems;
  problems.add({scenario.initial_state.origin, "<scenario><initial_state>", std::move(message), std::move(remedy)});
  throw InvalidInput(std::move(problems));
}

// At rest x' = 0 under constant heights: A x = -B (eta, 0). The rates of x come out as zero.
Eigen::VectorXd restOnRail(const StateSpace& matrices, const Scenario& scenario, const Input& input) {
  Eigen::VectorXd u(matrices.B.cols());
  input.evaluate(0, input.begin(), {u.data(), static_cast<std::size_t>(u.size())});
  u.tail(u.size() / 2).setZero();
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(matrices.A);
  if (!lu.isInvertible()) {
    refuse(scenario, "from=\"on_rail\" needs one rest position, but a motion has no stiffness",
           "carry every body by springs or start from=\"zero\"");
  }
  return lu.solve(-(matrices.B * u));
}

Eigen::VectorXd restState(const StateSpace& matrices, const Scenario& scenario, const Input& input) {
  switch (scenario.initial_state.from) {
    case InitialRest::kZero: break;
    case InitialRest::kOnRail: return restOnRail(matrices, scenario, input);
    case InitialRest::kPeriodic:
      if (const double growth = MotionRates(matrices.A).growth(); growth > 0.0) {
        refuse(scenario,
               fmt::format("from=\"periodic\" needs a vehicle whose motions die out, but one doubles every {:.3g} s",
                           std::numbers::ln2 / growth),
               "`vehicle check` names what makes it unstable; from=\"zero\" shows how it grows");
      }
      try {
        return steadyState(matrices, input.segment(0), input.begin());
      } catch (const std::invalid_argument& error) {
        refuse(scenario, fmt::format("from=\"periodic\": {}", error.what()), "start from=\"zero\" or from=\"on_rail\"");
      }
  }
  return Eigen::VectorXd::Zero(matrices.A.rows());
}

void addTo(std::vector<double>& x, const System& system, const std::string& name, double value) {
  const std::vector<Channel>& states = system.states();
  const auto state = std::find_if(states.begin(), states.end(), [&](const Channel& c) { return c.name == name; });
  // check(scenario, vehicle) has refused initial values of motions that a part does not have.
  if (state != states.end()) x[static_cast<std::size_t>(state - states.begin())] += value;
}

}  // namespace

std::vector<double> initialState(const System& system, const CompiledModel& model, const Scenario& scenario,
                                 const Input& input) {
  std::vector<double> x(static_cast<std::size_t>(system.size()), 0.0);
  if (scenario.initial_state.from != InitialRest::kZero) {
    std::optional<StateSpace> matrices = system.linear();
    if (!matrices) matrices = buildMatrixForm(model)->linear();
    const Eigen::VectorXd rest = restState(*matrices, scenario, input);
    std::copy(rest.begin(), rest.end(), x.begin());
  }
  for (const InitialBody& body : scenario.initial_state.bodies) {
    addTo(x, system, body.name + ".z", body.z);
    addTo(x, system, body.name + ".pitch", body.pitch);
    addTo(x, system, body.name + ".vz", body.z_rate);
    addTo(x, system, body.name + ".pitch_rate", body.pitch_rate);
  }
  return x;
}

}  // namespace vehicle
