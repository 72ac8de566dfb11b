#include "libvehicle/study/compare/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "libvehicle/study/plan/counted_random.h"

namespace vehicle {

namespace {

/// What one block adds to the sums, side by side: a + b, a^2 + b^2, then first and total of each factor.
class BlockTerms {
 public:
  BlockTerms(std::span<const double> values, std::size_t factors, const std::vector<std::size_t>& whole, double mean)
      : width_(2 + 2 * factors) {
    terms_.reserve(whole.size() * width_);
    for (const std::size_t block : whole) {
      const std::span<const double> y = values.subspan(block * (factors + 2), factors + 2);
      const double a = y[0] - mean;
      const double b = y[1] - mean;
      terms_.push_back(a + b);
      terms_.push_back(a * a + b * b);
      for (std::size_t i = 0; i < factors; ++i) {
        const double mixed_in = y[i + 2] - mean;
        terms_.push_back(b * (mixed_in - a));
        terms_.push_back(0.5 * (a - mixed_in) * (a - mixed_in));
      }
    }
  }

  [[nodiscard]] std::size_t width() const { return width_; }
  void add(std::size_t block, std::vector<double>& sums) const {
    for (std::size_t i = 0; i < width_; ++i) sums[i] += terms_[block * width_ + i];
  }

 private:
  std::size_t width_;
  std::vector<double> terms_;  // (blocks x width)
};

double varianceOf(const std::vector<double>& sums, double blocks) {
  const double mean = sums[0] / (2.0 * blocks);
  return sums[1] / (2.0 * blocks) - mean * mean;
}

Estimate intervalOf(double value, std::vector<double>& repeated) {
  if (repeated.empty()) return {value, value, value};
  std::sort(repeated.begin(), repeated.end());
  const auto at = [&](double share) {
    return repeated[static_cast<std::size_t>(std::lround(share * static_cast<double>(repeated.size() - 1)))];
  };
  return {value, at(0.025), at(0.975)};
}

}  // namespace

SensitivityResult sensitivityOf(std::span<const double> values, std::size_t factors, std::size_t repetitions,
                                std::uint64_t seed) {
  const std::size_t members = factors + 2;
  if (factors == 0 || values.size() % members != 0) {
    throw std::invalid_argument("sensitivityOf: values must be whole blocks of factors + 2, factors >= 1");
  }
  SensitivityResult result;
  std::vector<std::size_t> whole;
  double sum = 0.0;
  for (std::size_t block = 0; block < values.size() / members; ++block) {
    const std::span<const double> y = values.subspan(block * members, members);
    if (!std::all_of(y.begin(), y.end(), [](double each) { return std::isfinite(each); })) continue;
    whole.push_back(block);
    sum += y[0] + y[1];
  }
  result.blocks = whole.size();
  result.left_out = values.size() / members - whole.size();
  if (whole.empty()) return result;
  const auto blocks = static_cast<double>(whole.size());
  result.mean = sum / (2.0 * blocks);

  const BlockTerms terms(values, factors, whole, result.mean);
  std::vector<double> sums(terms.width(), 0.0);
  for (std::size_t block = 0; block < whole.size(); ++block) terms.add(block, sums);
  result.variance = std::max(0.0, varianceOf(sums, blocks));
  // What rounding leaves of a constant is no variance.
  constexpr double kRounding = 1e-24;
  if (whole.size() < 2 || !(result.variance > kRounding * result.mean * result.mean)) return result;

  std::vector<std::vector<double>> repeated(2 * factors);
  for (std::size_t repetition = 0; repetition < repetitions; ++repetition) {
    std::vector<double> drawn(terms.width(), 0.0);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      terms.add(countedRandom(seed, repetition, i) % whole.size(), drawn);
    }
    const double variance = varianceOf(drawn, blocks);
    if (!(variance > 0.0)) continue;
    for (std::size_t i = 0; i < 2 * factors; ++i) repeated[i].push_back(drawn[2 + i] / blocks / variance);
  }
  for (std::size_t i = 0; i < factors; ++i) {
    SensitivityIndex index;
    index.first = intervalOf(sums[2 + 2 * i] / blocks / result.variance, repeated[2 * i]);
    index.total = intervalOf(sums[3 + 2 * i] / blocks / result.variance, repeated[2 * i + 1]);
    result.indices.push_back(index);
  }
  return result;
}

}  // namespace vehicle
