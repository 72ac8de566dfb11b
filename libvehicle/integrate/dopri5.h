#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "libvehicle/integrate/state_array.h"
#include "libvehicle/integrate/tableau.h"

namespace vehicle {

/// One step of Dormand-Prince 5(4) with error estimate and dense output; who chooses the steps is adaptive_steps.h.
///
/// Six evaluations a step: the last stage is the first of the next one (begin() makes the very first and the first
/// after a breakpoint, where f jumps). Owns its stage vectors: stepping never allocates.
/// Source: tableau.h, kDopri5.
///
/// @tparam Rhs  callable as rhs(const double* x, const double* u, double* dx)
template <class Rhs, int N = kDynamicSize>
class Dopri5 {
 public:
  static constexpr const char* kName = "dopri5";
  static constexpr int kEvaluations = 6;  // of f in one attempt
  static constexpr int kOrder = 5;

  explicit Dopri5(Rhs rhs, int size = N)
      : rhs_(std::move(rhs)),
        slopes_{StateArray<N>(size), StateArray<N>(size), StateArray<N>(size), StateArray<N>(size),
                StateArray<N>(size), StateArray<N>(size), StateArray<N>(size)},
        start_(size), stage_(size), error_(size) {}

  [[nodiscard]] int size() const { return start_.size(); }

  /// Puts the stepper at x, with f evaluated there.
  void begin(const double* x, const double* u) {
    std::copy_n(x, size(), start_.data());
    rhs_(start_.data(), u, slopes_[0].data());
  }

  /// Evaluates the six further stages of a step of size h from where the stepper stands.
  /// @param u  (7 x width), row-major: the input at t + c_i h; row 0 is not read
  void attempt(double h, const double* u, int width) {
    h_ = h;
    stages<1>(u, width);
    for (int i = 0; i < size(); ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < 7; ++j) sum += (kDopri5.b[j] - kDopri5Embedded[j]) * slopes_[j][i];
      error_[i] = h * sum;
    }
  }

  /// Root of the mean square of error_i / (absolute + relative max(|x_i|, |new x_i|)); at most 1 is accepted. NaN
  /// where the attempt ran into NaN.
  [[nodiscard]] double errorNorm(double absolute, double relative) const {
    double sum = 0.0;
    for (int i = 0; i < size(); ++i) {
      const double scale = absolute + relative * std::max(std::abs(start_[i]), std::abs(stage_[i]));
      sum += error_[i] / scale * (error_[i] / scale);
    }
    return std::sqrt(sum / size());
  }

  /// State at the fraction s of the attempted step, 0 <= s <= 1. Error O(h^5) inside the step.
  void dense(double s, double* x) const {
    std::array<double, 7> weight;
    for (int j = 0; j < 7; ++j) weight[static_cast<std::size_t>(j)] = h_ * dopri5DenseWeight(j, s);
    for (int i = 0; i < size(); ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < 7; ++j) sum += weight[j] * slopes_[j][i];
      x[i] = start_[i] + sum;
    }
  }

  /// Moves to the end of the attempted step.
  void accept() {
    start_.swap(stage_);
    slopes_[0].swap(slopes_[6]);
  }

  [[nodiscard]] const double* state() const { return start_.data(); }      // where the step begins
  [[nodiscard]] const double* slope() const { return slopes_[0].data(); }  // f there
  [[nodiscard]] const double* proposal() const { return stage_.data(); }   // where the attempted step ends
  Rhs& rhs() { return rhs_; }

 private:
  template <std::size_t kStage>
  void stages(const double* u, int width) {
    for (int i = 0; i < size(); ++i) {
      double sum = kDopri5.a[kStage][0] * slopes_[0][i];
      for (std::size_t j = 1; j < kStage; ++j) {
        if (kDopri5.a[kStage][j] != 0.0) sum += kDopri5.a[kStage][j] * slopes_[j][i];
      }
      stage_[i] = start_[i] + h_ * sum;
    }
    rhs_(stage_.data(), u + static_cast<std::ptrdiff_t>(kStage) * width, slopes_[kStage].data());
    if constexpr (kStage < 6) stages<kStage + 1>(u, width);
  }

  Rhs rhs_;
  std::array<StateArray<N>, 7> slopes_;
  StateArray<N> start_;
  StateArray<N> stage_;
  StateArray<N> error_;
  double h_ = 0.0;
};

}  // namespace vehicle
