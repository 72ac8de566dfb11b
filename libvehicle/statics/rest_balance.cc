#include "libvehicle/statics/rest_balance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <Eigen/QR>

namespace vehicle {
namespace {

// Contact springs are about 1000 times stiffer than suspensions, and the scaled matrix takes that out; below
// this share of its largest pivot a direction has no spring at all.
constexpr double kRank = 1e-12;
constexpr int kHertzIterations = 100;

/// K d = force
struct Equations {
  Eigen::MatrixXd stiffness;
  Eigen::VectorXd force;
};

Equations springEquations(const RestBalance& balance) {
  const Eigen::Index n = balance.weight.size();
  Equations made{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
  made.force -= balance.weight;
  for (const RestSpring& each : balance.springs) {
    if (each.preload) {
      made.force += *each.preload * each.row;
    } else {
      made.stiffness += each.law->slopes({}).elongation * each.row * each.row.transpose();
    }
  }
  return made;
}

/// Least deflections that satisfy the equations; motions without any spring stay at 0.
Eigen::VectorXd solve(const Equations& equations) {
  const Eigen::Index n = equations.force.size();
  if (n == 0) return {};
  Eigen::VectorXd scale(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double k = equations.stiffness(i, i);
    scale[i] = k > 0.0 ? 1.0 / std::sqrt(k) : 1.0;
  }
  const Eigen::MatrixXd scaled = scale.asDiagonal() * equations.stiffness * scale.asDiagonal();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(kRank);
  decomposition.compute(scaled);
  const Eigen::VectorXd right = scale.asDiagonal() * equations.force;
  Eigen::VectorXd solution = decomposition.solve(right);
  // One refinement brings the loads to rounding level, so that mirrored axles show equal loads to the last digits.
  solution += decomposition.solve(Eigen::VectorXd(right - scaled * solution));
  return scale.asDiagonal() * solution;
}

double loadOf(const RestSpring& spring, const Eigen::VectorXd& deflection) {
  return spring.preload ? *spring.preload : 0.0 - spring.law->force({.elongation = spring.row.dot(deflection)});
}

/// Wheel-rail forces by vertical equilibrium of each wheelset.
std::vector<double> contactLoads(const RestBalance& balance, const std::vector<double>& spring_load) {
  std::vector<double> loads;
  for (const RestContact& each : balance.contacts) {
    loads.push_back(each.weight);
    for (const std::size_t spring : each.above) loads.back() += spring_load[spring];
  }
  return loads;
}

double largestChange(const std::vector<double>& now, const std::vector<double>& before) {
  double change = 0.0;
  for (std::size_t j = 0; j < now.size(); ++j) change = std::max(change, std::abs(now[j] - before[j]));
  return change;
}

}  // namespace

RestSolution solveRest(const RestBalance& balance) {
  const Equations on_springs = springEquations(balance);
  // A Hertz spring is as stiff as its load makes it, F / delta = C^(2/3) F^(1/3), and where axles share a load
  // the load depends on that stiffness. Contacts are far stiffer than suspensions, so the loop contracts fast.
  RestSolution rest;
  const double wheelsets = static_cast<double>(balance.contacts.size());
  rest.contact_load.assign(balance.contacts.size(), balance.total / std::max(1.0, wheelsets));
  Equations equations;
  for (int iteration = 0; iteration < kHertzIterations; ++iteration) {
    equations = on_springs;
    bool hertz = false;
    for (std::size_t j = 0; j < balance.contacts.size(); ++j) {
      const RestContact& contact = balance.contacts[j];
      if (contact.coordinate < 0) continue;
      if (!contact.stiffness) hertz = true;
      equations.stiffness(contact.coordinate, contact.coordinate) +=
          contact.stiffness
              ? *contact.stiffness
              : std::cbrt(std::pow(contact.hertz_constant, 2.0) * std::max(rest.contact_load[j], 1e-9 * balance.total));
    }
    rest.deflection = solve(equations);
    rest.spring_load.clear();
    for (const RestSpring& each : balance.springs) rest.spring_load.push_back(loadOf(each, rest.deflection));
    const std::vector<double> before = std::exchange(rest.contact_load, contactLoads(balance, rest.spring_load));
    if (!hertz || largestChange(rest.contact_load, before) <= 1e-15 * balance.total) break;
  }
  rest.given = on_springs.force;
  rest.left = equations.force - equations.stiffness * rest.deflection;
  return rest;
}

}  // namespace vehicle
