#include "libvehicle/simulate/exact_integrals.h"

#include <array>

namespace vehicle {

namespace {

/// B_2k / (2k)!, k = 1 .. 6
constexpr std::array kBernoulli = {1.0 / 12.0,       -1.0 / 720.0,     1.0 / 30240.0,
                                   -1.0 / 1209600.0, 1.0 / 47900160.0, -691.0 / 1307674368000.0};
constexpr int kOrder = 2 * static_cast<int>(kBernoulli.size()) - 1;  // highest derivative in the formula
constexpr int kTaylor = 14;                                          // 0.5^15 / 15! is far below rounding

constexpr double binomial(int n, int k) {
  double value = 1.0;
  for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return value;
}

}  // namespace

ExactIntegrals::ExactIntegrals(const System& system, const Input& input, const Schedule& schedule)
    : input_(input), schedule_(schedule), derivatives_(system), first_(system.outputs().size(), 0.0), second_(first_) {}

void ExactIntegrals::begin(const Schedule::Part& part, double t, std::span<const double> x) {
  segment_ = part.segment;
  intervals_ = part.count;
  point_step_ = schedule_.outputStep() / part.cut;
  odd_first_ = !part.first_whole;
  odd_last_ = !part.last_whole && part.count > 1;
  if (part.count == 1) odd_first_ = odd_first_ || !part.last_whole;
  const Interval last = schedule_.intervals()[part.first_interval + part.count - 1];
  last_length_ = last.end - last.begin;
  time_ += part.end - part.begin;
  if (odd_first_) return addTaylor(t, x, schedule_.intervals()[part.first_interval].end - t);
  addEnd(t, x, -1.0);
}

void ExactIntegrals::add(std::size_t own, double t, std::span<const double> x, std::span<const double> y) {
  const std::size_t first = odd_first_ ? 1 : 0;  // samples of the equal intervals
  const std::size_t last = odd_last_ ? intervals_ - 1 : intervals_;
  const std::size_t sample = own + 1;
  if (sample < first || sample > last || first == last) {
    // Nothing but odd intervals: the second begins where the first has ended.
    if (sample == last && odd_last_ && first == last) addTaylor(t, x, last_length_);
    return;
  }
  if (sample == first) addEnd(t, x, -1.0);
  if (sample == last) {
    addSample(0.5 * point_step_, y);
    addEnd(t, x, 1.0);
    if (odd_last_) addTaylor(t, x, last_length_);
    return;
  }
  if (sample > first) addSample(point_step_, y);
}

void ExactIntegrals::addSample(double weight, std::span<const double> y) {
  for (std::size_t i = 0; i < y.size(); ++i) {
    first_[i] += weight * y[i];
    second_[i] += weight * y[i] * y[i];
  }
}

// What the trapezoidal rule owes to an end of the equal intervals, and at their begin its half sample.
// @param sign  -1 at the begin, 1 at the end
void ExactIntegrals::addEnd(double t, std::span<const double> x, double sign) {
  const Eigen::MatrixXd& y = derivatives_.at(input_.segment(segment_), t, x, kOrder);
  for (Eigen::Index i = 0; i < y.rows(); ++i) {
    double first = 0.0, second = 0.0;
    double power = 1.0;
    for (std::size_t k = 0; k < kBernoulli.size(); ++k) {
      power *= point_step_ * point_step_;
      const int m = 2 * static_cast<int>(k) + 1;
      double of_square = 0.0;  // the m-th derivative of y^2
      for (int j = 0; j <= m; ++j) of_square += binomial(m, j) * y(i, j) * y(i, m - j);
      first += kBernoulli[k] * power * y(i, m);
      second += kBernoulli[k] * power * of_square;
    }
    const auto column = static_cast<std::size_t>(i);
    first_[column] -= sign * first;
    second_[column] -= sign * second;
    if (sign > 0.0) continue;
    first_[column] += 0.5 * point_step_ * y(i, 0);
    second_[column] += 0.5 * point_step_ * y(i, 0) * y(i, 0);
  }
}

void ExactIntegrals::addTaylor(double t, std::span<const double> x, double length) {
  const Eigen::MatrixXd& y = derivatives_.at(input_.segment(segment_), t, x, kTaylor);
  for (Eigen::Index i = 0; i < y.rows(); ++i) {
    std::array<double, kTaylor + 1> term;  // y^(k) h^k / k!
    double factor = 1.0;
    for (int k = 0; k <= kTaylor; ++k) {
      term[static_cast<std::size_t>(k)] = factor * y(i, k);
      factor *= length / (k + 1);
    }
    double first = 0.0, second = 0.0;
    for (std::size_t j = 0; j < term.size(); ++j) {
      first += term[j] / static_cast<double>(j + 1);
      for (std::size_t k = 0; k < term.size(); ++k) second += term[j] * term[k] / static_cast<double>(j + k + 1);
    }
    first_[static_cast<std::size_t>(i)] += length * first;
    second_[static_cast<std::size_t>(i)] += length * second;
  }
}

}  // namespace vehicle
