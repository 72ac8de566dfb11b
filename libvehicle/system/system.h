#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "libvehicle/system/equation_set.h"
#include "libvehicle/system/layout.h"
#include "libvehicle/units/channel.h"

namespace vehicle {

/// x' = A x + B u with u = (eta, eta'), of a linear system.
struct StateSpace {
  Eigen::MatrixXd A;  // (n x n) [1/s and mixed]
  Eigen::MatrixXd B;  // (n x 2 w)
};

/// What a solver may ask of a model: time-invariant x' = f(x, u), state x = (q, q', z) as layout() has it.
/// The input u(t) comes from outside (input.h), so that solvers can ask for it in blocks.
class System {
 public:
  virtual ~System() = default;

  [[nodiscard]] virtual int channels() const = 0;                            // w, wheelsets
  [[nodiscard]] virtual StateLayout layout() const = 0;                      // where q, q' and internal states stand
  [[nodiscard]] virtual const std::vector<Channel>& states() const = 0;      // n names and units
  [[nodiscard]] virtual const std::vector<Channel>& outputs() const = 0;     // columns of a result after `time`
  [[nodiscard]] int size() const { return static_cast<int>(states().size()); }

  /// dx/dt = f(x, u). Never allocates in linear forms. Not to be called concurrently on one object unless the
  /// form says so.
  /// @param x   (n)   @param u  (2 w) heights, rates   @param dx  (n)
  virtual void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const = 0;

  /// All columns of a result at one instant, accelerations and forces included.
  /// @param x  (n)   @param u  (3 w) heights, rates, accelerations   @param y  (outputs)
  virtual void output(std::span<const double> x, std::span<const double> u, std::span<double> y) const = 0;

  /// The matrices of a linear, time-invariant system; nothing for a nonlinear one.
  /// @throws std::invalid_argument beyond kMostDenseStates
  [[nodiscard]] virtual std::optional<StateSpace> linear() const { return std::nullopt; }

  /// f(x, u) cut into equations that threads may share; nullptr where it cannot be cut. It lives as long as the system.
  [[nodiscard]] virtual const EquationSet* equations() const { return nullptr; }
};

/// Most states whose matrices are made: beyond, each takes gigabytes and what is done with them hours.
inline constexpr int kMostDenseStates = 2000;
/// @param who  e.g. "flat"
/// @throws std::invalid_argument if there are more states than kMostDenseStates, naming the way out
void requireDense(const char* who, int states);

/// A and B of any system about (x0, u0) by central differences, one column a perturbation.
/// @param scale  size of the perturbation relative to the unit scales (1 m, 1 rad, 1 m/s, 1 rad/s); for a
///               linear system any value gives the matrices up to rounding, for a nonlinear one the error is
///               O(scale^2) + O(1e-16 |f| / scale)
[[nodiscard]] StateSpace differencedStateSpace(const System& system, std::span<const double> x0,
                                               std::span<const double> u0, double scale);

}  // namespace vehicle
