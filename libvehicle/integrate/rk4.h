#pragma once

#include <utility>

#include "libvehicle/integrate/rk4_stages.h"
#include "libvehicle/integrate/state_array.h"

namespace vehicle {

/// Classical four-stage Runge-Kutta step of fixed size, global error O(h^4) where u is smooth inside the step.
///
/// A template over right-hand side and size: with a fixed N the compiler sees the whole step; the dynamic size
/// gives the same bits. Owns its stage vectors: constructing may allocate, stepping never does.
/// Source: tableau.h, kRk4.
///
/// @tparam Rhs  dx/dt = f(x, u): callable as rhs(const double* x, const double* u, double* dx)
/// @tparam N    number of states, or kDynamicSize
template <class Rhs, int N = kDynamicSize>
class Rk4 {
 public:
  static constexpr const char* kName = "rk4";
  static constexpr int kEvaluations = 4;  // of f in one step, in stage order

  /// @throws std::invalid_argument if size < 1, or size != N where N is fixed
  explicit Rk4(Rhs rhs, int size = N) : rhs_(std::move(rhs)), slope_(size), sum_(size), stage_(size) {}

  [[nodiscard]] int size() const { return slope_.size(); }

  /// Moves x from t to t + h.
  /// @param h  [s], > 0
  /// @param u_begin, u_middle, u_end  the input at t, t + h/2, t + h: limits from inside the step
  /// @param x  (n), updated in place
  void step(double h, const double* u_begin, const double* u_middle, const double* u_end, double* x) {
    rhs_(x, u_begin, slope_.data());
    afterFirstStage(h, x, slope_.data(), sum_.data(), stage_.data(), size());
    rhs_(stage_.data(), u_middle, slope_.data());
    afterMiddleStage<1>(h, x, slope_.data(), sum_.data(), stage_.data(), size());
    rhs_(stage_.data(), u_middle, slope_.data());
    afterMiddleStage<2>(h, x, slope_.data(), sum_.data(), stage_.data(), size());
    rhs_(stage_.data(), u_end, slope_.data());
    afterLastStage(h, slope_.data(), sum_.data(), x, size());
  }

 private:
  Rhs rhs_;
  StateArray<N> slope_;
  StateArray<N> sum_;
  StateArray<N> stage_;
};

}  // namespace vehicle
