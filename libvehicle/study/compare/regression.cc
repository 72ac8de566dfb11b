#include "libvehicle/study/compare/regression.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace vehicle {

Regression::Regression(std::size_t factors)
    : means_(factors + 1, 0.0), moments_((factors + 1) * (factors + 1), 0.0), step_(factors + 1, 0.0) {}

void Regression::add(std::span<const double> x, double y) {
  const std::size_t size = means_.size();
  if (x.size() + 1 != size) throw std::invalid_argument("Regression: x has another size than there are factors");
  const bool finite =
      std::isfinite(y) && std::all_of(x.begin(), x.end(), [](double each) { return std::isfinite(each); });
  if (!finite) return;
  ++count_;
  const auto count = static_cast<double>(count_);
  for (std::size_t i = 0; i < size; ++i) step_[i] = (i + 1 < size ? x[i] : y) - means_[i];
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = i; j < size; ++j) {
      moments_[i * size + j] += step_[i] * step_[j] * (count - 1.0) / count;
      moments_[j * size + i] = moments_[i * size + j];
    }
  }
  for (std::size_t i = 0; i < size; ++i) means_[i] += step_[i] / count;
}

// What rounding leaves of a constant is no variation.
bool Regression::varies(std::size_t i) const {
  constexpr double kRounding = 1e-24;
  return moment(i, i) > kRounding * static_cast<double>(count_) * means_[i] * means_[i];
}

std::vector<double> Regression::correlations() const {
  const std::size_t y = means_.size() - 1;
  std::vector<double> all(y, 0.0);
  for (std::size_t i = 0; i < y; ++i) {
    if (!varies(i) || !varies(y)) continue;
    all[i] = std::clamp(moment(i, y) / (std::sqrt(moment(i, i)) * std::sqrt(moment(y, y))), -1.0, 1.0);
  }
  return all;
}

std::optional<Regression::Fit> Regression::fit() const {
  const std::size_t y = means_.size() - 1;
  if (y == 0 || count_ < y + 2 || !varies(y)) return std::nullopt;
  for (std::size_t i = 0; i < y; ++i) {
    if (!varies(i)) return std::nullopt;
  }
  const auto correlation = [&](std::size_t i, std::size_t j) {
    return moment(i, j) / (std::sqrt(moment(i, i)) * std::sqrt(moment(j, j)));
  };
  // Cholesky of the factors' correlation matrix, R = L L^T; a pivot near 0 tells that one follows from the others.
  constexpr double kDependent = 1e-10;
  std::vector<double> lower(y * y, 0.0);
  const auto l = [&](std::size_t i, std::size_t j) -> double& { return lower[i * y + j]; };
  for (std::size_t i = 0; i < y; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = i == j ? 1.0 : correlation(i, j);
      for (std::size_t k = 0; k < j; ++k) rest -= l(i, k) * l(j, k);
      if (i == j && rest < kDependent) return std::nullopt;
      l(i, j) = i == j ? std::sqrt(rest) : rest / l(j, j);
    }
  }
  Fit fit;
  fit.coefficients.resize(y);
  std::vector<double>& b = fit.coefficients;
  for (std::size_t i = 0; i < y; ++i) {
    b[i] = correlation(i, y);
    for (std::size_t k = 0; k < i; ++k) b[i] -= l(i, k) * b[k];
    b[i] /= l(i, i);
  }
  for (std::size_t i = y; i-- > 0;) {
    for (std::size_t k = i + 1; k < y; ++k) b[i] -= l(k, i) * b[k];
    b[i] /= l(i, i);
  }
  for (std::size_t i = 0; i < y; ++i) fit.explained += b[i] * correlation(i, y);
  fit.explained = std::clamp(fit.explained, 0.0, 1.0);
  return fit;
}

}  // namespace vehicle
