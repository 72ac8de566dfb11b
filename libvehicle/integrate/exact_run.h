#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "libvehicle/integrate/exact.h"
#include "libvehicle/integrate/run.h"

namespace vehicle {

/// A whole run of exact propagation.
///
/// Propagators of a segment with harmonics live as long as the segment; without harmonics they and the polynomial gains
/// know nothing of the segment and are kept, so that thousands of stored samples share one.
class ExactRun {
 public:
  ExactRun(StateSpace matrices, const Input& input, const Schedule& schedule, std::span<const double> x0)
      : matrices_(std::move(matrices)),
        input_(input),
        schedule_(schedule),
        x_(Eigen::Map<const Eigen::VectorXd>(x0.data(), static_cast<Eigen::Index>(x0.size()))),
        u_(2 * input.channels()),
        slope_(x_.size()) {}

  /// @param arrive  arrive(const Interval&, std::span<const double> x) at the end of every interval; false ends the run
  template <class Arrive>
  Statistics run(Arrive arrive) {
    for (const Interval interval : schedule_.intervals()) {
      move(interval);
      if (!arrive(interval, state())) break;
    }
    return statistics_;
  }

  [[nodiscard]] std::span<const double> state() const { return {x_.data(), static_cast<std::size_t>(x_.size())}; }

 private:
  void move(const Interval& interval) {
    const InputSegment& segment = input_.segment(interval.segment);
    if (interval.segment != segment_) enter(interval.segment);
    const double length = interval.end - interval.begin;
    ExactPropagator& propagator = propagatorFor(length, interval.whole);
    if (&propagator != seeded_ || turns_ == kReseed) {
      propagator.seed(interval.begin - segment.begin, oscillators_.data());
      seeded_ = &propagator;
      turns_ = 0;
    }
    const PolynomialGain* gain = polynomial_ ? &gainFor(propagator.length()) : nullptr;
    propagator.propagate(x_.data(), oscillators_.data());
    if (gain != nullptr) gain->add(segment, interval.begin - segment.begin, x_.data());
    ++turns_;
    ++statistics_.steps;
    lag_ += length - propagator.length();
    catchUp(interval);
  }

  void enter(int index) {
    segment_ = index;
    const InputSegment& segment = input_.segment(index);
    harmonic_ = !segment.angular_frequency.empty();
    polynomial_ = std::any_of(segment.polynomial.begin(), segment.polynomial.end(), [](double p) { return p != 0.0; });
    of_segment_.clear();
    seeded_ = nullptr;
    forcing_ = harmonicForcing(matrices_, segment);
    oscillators_.resize(2 * segment.angular_frequency.size());
  }

  // Lengths come as differences of instants and carry the rounding of the clock. A propagator is made for the exact
  // output step where that is meant, else for the first length met. The difference would add up to a clock that
  // runs late, which the fastest mode would see at once: x moves on by it, to first order, before it matters.
  void catchUp(const Interval& interval) {
    if (std::abs(lag_) <= 4.0 * std::numeric_limits<double>::epsilon() * std::abs(interval.end)) return;
    input_.evaluate(interval.segment, interval.end, {u_.data(), static_cast<std::size_t>(u_.size())});
    slope_.noalias() = matrices_.A * x_;
    slope_.noalias() += matrices_.B * u_;
    x_ += lag_ * slope_;
    lag_ = 0.0;
    seeded_ = nullptr;
  }

  // @param whole  [s] the length that is meant, or 0
  ExactPropagator& propagatorFor(double length, double whole) {
    auto& known = harmonic_ ? of_segment_ : free_;
    for (const auto& propagator : known) {
      if (std::abs(propagator->length() - length) <= kSameLength * length) return *propagator;
    }
    makeRoom(known);
    const std::vector<double>& w = input_.segment(segment_).angular_frequency;
    known.push_back(std::make_unique<ExactPropagator>(matrices_.A, forcing_, w, whole > 0.0 ? whole : length));
    statistics_.evaluations += known.back()->exponentials();
    return *known.back();
  }

  // Stored samples and output samples without a common step: every length is new, and the oldest goes.
  template <class List>
  void makeRoom(List& list) {
    if (list.size() < kMostKept) return;
    list.erase(list.begin());
    seeded_ = nullptr;
  }

  const PolynomialGain& gainFor(double length) {
    for (const auto& gain : gains_) {
      if (gain->length() == length) return *gain;
    }
    makeRoom(gains_);
    gains_.push_back(std::make_unique<PolynomialGain>(matrices_, length));
    ++statistics_.evaluations;
    return *gains_.back();
  }

  static constexpr int kReseed = 64;  // steps of an oscillator by rotation
  // Two lengths that differ by less share a propagator; what is missing is made good by first order (see catchUp).
  static constexpr double kSameLength = 1e-9;
  static constexpr std::size_t kMostKept = 256;

  StateSpace matrices_;
  const Input& input_;
  const Schedule& schedule_;
  Eigen::VectorXd x_;
  Eigen::VectorXd u_;
  Eigen::VectorXd slope_;
  Statistics statistics_;
  double lag_ = 0.0;  // [s] by which x_ is behind the clock

  int segment_ = -1;
  bool harmonic_ = false;
  bool polynomial_ = false;
  Eigen::MatrixXd forcing_;
  std::vector<double> oscillators_;
  const ExactPropagator* seeded_ = nullptr;  // the one that turns the oscillators now
  int turns_ = 0;

  // By pointer: seeded_ and callers keep looking at one while its list grows.
  std::vector<std::unique_ptr<ExactPropagator>> of_segment_;
  std::vector<std::unique_ptr<ExactPropagator>> free_;
  std::vector<std::unique_ptr<PolynomialGain>> gains_;
};

/// A, B of a system for the exact method, after the checks that every exact run begins with.
/// @throws std::invalid_argument for an input or a start that does not fit, or a system without matrices
[[nodiscard]] StateSpace matricesForExact(const System& system, const Input& input, std::span<const double> x0);

}  // namespace vehicle
