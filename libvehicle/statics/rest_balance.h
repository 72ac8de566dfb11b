#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "libvehicle/law/suspension_law.h"

namespace vehicle {

// The loaded rest position of springs and weights, by coordinates: `model` knows which part each of them is.

/// A suspension between coordinates: its elongation is row . q.
struct RestSpring {
  Eigen::VectorXd row;  // (q)
  SuspensionLawPtr law;
  std::optional<double> preload;  // [N] compression, given: it then takes the place of the law's force
};

/// What carries a wheelset: the rail itself, or a contact spring.
struct RestContact {
  int coordinate = -1;              // of the wheelset's height; -1: it follows the rail
  double weight = 0.0;              // [N] of the wheelset
  std::vector<std::size_t> above;   // springs that stand on it
  std::optional<double> stiffness;  // [N/m] linear; else Hertz
  double hertz_constant = 0.0;      // C [N/m^1.5], F = C delta^1.5
};

/// What rests on what.
struct RestBalance {
  Eigen::VectorXd weight;  // [N] (q) that acts on each coordinate downwards
  double total = 0.0;      // [N] weight of all bodies
  std::vector<RestSpring> springs;
  std::vector<RestContact> contacts;
};

/// Where it comes to rest.
struct RestSolution {
  Eigen::VectorXd deflection;        // [m, rad] (q) from unloaded springs to rest
  std::vector<double> spring_load;   // [N] (springs) compression-positive
  std::vector<double> contact_load;  // [N] (contacts) wheel-rail force, compression-positive
  Eigen::VectorXd given;             // [N, N m] (q) weights and given preloads
  Eigen::VectorXd left;              // [N, N m] (q) what the springs do not take up; 0 but for rounding where they can
};

/// With all springs unloaded at zero deflection, K d = -m g gives the deflections d; the load of a spring is what its law
/// says of its compression. Where equilibrium alone leaves a choice (two axles under a bogie that does not pitch) it is
/// the least deflection. A motion without any spring stays at 0. Hertz contacts are iterated, being as stiff as their load
/// makes them. Cost: a few complete orthogonal decompositions, ~ (q)^3.
/// @param balance  springs of linear laws
[[nodiscard]] RestSolution solveRest(const RestBalance& balance);

}  // namespace vehicle
