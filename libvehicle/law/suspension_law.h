#pragma once

// Compiled as C++17 too: the Simbody force element calls the same functions as every other form.
#include <memory>
#include <string>
#include <vector>

namespace vehicle {

/// What a law sees of its suspension at one instant.
struct LawPoint {
  double elongation = 0.0;           // d [m] from the loaded rest position, positive where the ends move apart
  double rate = 0.0;                 // v = d' [m/s]
  const double* internal = nullptr;  // y (internalStates()) the law's own states
  int mode = 0;                      // the smooth branch that holds: 0 .. modes() - 1
};

/// How a law's force and state rates change with what it sees, at one point.
struct LawSlopes {
  double elongation = 0.0;       // df/dd [N/m]
  double rate = 0.0;             // df/dv [N s/m]
  std::vector<double> internal;  // df/dy (internalStates())
  std::vector<double> rates;     // dg/d(d, v, y), shape (internalStates() x (2 + internalStates())), row-major
};

/// A state that a law has of its own.
struct LawState {
  std::string name;  // after the suspension's: ".series_force"
  std::string unit;
};

/// The force of a suspension from its elongation: what matrix form, Simbody force element and statics share. A law knows
/// no vehicle and no solver. Inside a mode everything is smooth, so that a step may overshoot an event and is then
/// shortened. Laws of one suspension act in parallel. Immutable: one object serves any number of suspensions and threads.
///
///     force        f(d, v, y, mode)  [N], positive in elongation: it pulls the two ends together
///     state rates  y' = g(d, v, y, mode)
class SuspensionLaw {
 public:
  virtual ~SuspensionLaw() = default;

  /// Whether f is linear in (d, v) and there are no modes: matrices, modes and the exact method exist.
  [[nodiscard]] virtual bool isLinear() const = 0;

  [[nodiscard]] virtual double force(const LawPoint& at) const = 0;
  [[nodiscard]] virtual LawSlopes slopes(const LawPoint& at) const = 0;

  /// [J] that springs hold, 0 at rest.
  [[nodiscard]] virtual double storedEnergy(const LawPoint& at) const = 0;
  /// [W] that becomes heat, >= 0:   force * rate = d(stored)/dt + dissipated
  [[nodiscard]] virtual double dissipatedPower(const LawPoint& at) const = 0;

  [[nodiscard]] virtual std::vector<LawState> internalStates() const { return {}; }
  /// @param rates  g, shape (internalStates())
  virtual void stateRates(const LawPoint& /*at*/, double* /*rates*/) const {}

  [[nodiscard]] virtual int modes() const { return 1; }
  /// How many events end that mode.
  [[nodiscard]] virtual int events(int /*mode*/) const { return 0; }
  /// Stays >= 0 while the mode holds; its zero is the event.
  [[nodiscard]] virtual double guard(const LawPoint& /*at*/, int /*event*/) const { return 1.0; }
  /// The mode that follows that event.
  [[nodiscard]] virtual int modeAfter(const LawPoint& at, int /*event*/) const { return at.mode; }
  /// What the change to at.mode does to the law's own states (a turning point is remembered, a force set to its limit).
  /// @param internal  y, updated in place
  virtual void enter(const LawPoint& /*at*/, double* /*internal*/) const {}
};

/// Shared, because every form of a vehicle calls the same object and may outlive the others.
using SuspensionLawPtr = std::shared_ptr<const SuspensionLaw>;

}  // namespace vehicle
