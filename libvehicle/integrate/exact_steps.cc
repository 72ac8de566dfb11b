#include "libvehicle/integrate/exact_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "libvehicle/integrate/failure.h"

namespace vehicle {
namespace {

constexpr const char* kName = "exact";
constexpr int kReseed = 64;  // steps of an oscillator by rotation
// Two lengths that differ by less share a propagator; what is missing is made good by first order (see catchUp).
constexpr double kSameLength = 1e-9;
constexpr std::size_t kMostKept = 256;

StateSpace matricesOf(const System& system) {
  std::optional<StateSpace> matrices = system.linear();
  if (!matrices) {
    throw std::invalid_argument(
        "exact: the system is nonlinear (it has no matrices A, B); exact propagation needs a linear one, take rk4 or "
        "dopri5");
  }
  return std::move(*matrices);
}

}  // namespace

ExactSteps::ExactSteps(const System& system, const Input& input)
    : matrices_((checkChannels(kName, system.channels(), input.channels()), matricesOf(system))),
      input_(input),
      x_(matrices_.A.rows()),
      u_(2 * input.channels()),
      slope_(x_.size()) {
  for (int s = 0; s < input.segments(); ++s) requireClosedForm(kName, "take rk4 or dopri5", input.segment(s));
}

void ExactSteps::restart(const Interval&, std::span<const double> x) {
  checkStart(kName, x, static_cast<int>(x_.size()));
  std::copy(x.begin(), x.end(), x_.data());
  lag_ = 0.0;
  segment_ = -1;
}

void ExactSteps::advance(const Interval& interval) {
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
  requireFinite(kName, interval.end, state());
}

void ExactSteps::enter(int index) {
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
void ExactSteps::catchUp(const Interval& interval) {
  if (std::abs(lag_) <= 4.0 * std::numeric_limits<double>::epsilon() * std::abs(interval.end)) return;
  input_.evaluate(interval.segment, interval.end, {u_.data(), static_cast<std::size_t>(u_.size())});
  slope_.noalias() = matrices_.A * x_;
  slope_.noalias() += matrices_.B * u_;
  x_ += lag_ * slope_;
  lag_ = 0.0;
  seeded_ = nullptr;
}

// @param whole  [s] the length that is meant, or 0
ExactPropagator& ExactSteps::propagatorFor(double length, double whole) {
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
void ExactSteps::makeRoom(List& list) {
  if (list.size() < kMostKept) return;
  list.erase(list.begin());
  seeded_ = nullptr;
}

const PolynomialGain& ExactSteps::gainFor(double length) {
  for (const auto& gain : gains_) {
    if (gain->length() == length) return *gain;
  }
  makeRoom(gains_);
  gains_.push_back(std::make_unique<PolynomialGain>(matrices_, length));
  ++statistics_.evaluations;
  return *gains_.back();
}

}  // namespace vehicle
