#include "libvehicle/study/compare/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "libvehicle/study/plan/counted_random.h"
#include "libvehicle/study/plan/design_plan.h"

namespace vehicle {

namespace {

/// Where the numbers of a block, and of sums over blocks, stand.
struct Terms {
  std::size_t factors = 0;
  SecondOrder order = SecondOrder::kNo;

  static constexpr std::size_t kSum = 0;      // y_A + y_B
  static constexpr std::size_t kSquares = 1;  // y_A^2 + y_B^2
  [[nodiscard]] std::size_t first(std::size_t i) const { return 2 + 2 * i; }
  [[nodiscard]] std::size_t total(std::size_t i) const { return 3 + 2 * i; }
  [[nodiscard]] std::size_t pair(std::size_t number) const { return 2 + 2 * factors + number; }
  [[nodiscard]] std::size_t pairs() const { return order == SecondOrder::kYes ? factors * (factors - 1) / 2 : 0; }
  [[nodiscard]] std::size_t size() const { return pair(pairs()); }
};

/// What one block adds to the sums, each a mean over blocks of which gives V times its index. Those of pairs are
/// closed: with what the two factors do alone.
/// @param y     centred values of the block
/// @param sums  shape (terms.size()), written
void writeTerms(std::span<const double> y, const Terms& terms, std::span<double> sums) {
  const std::size_t k = terms.factors;
  const double a = y[0];
  const double b = y[1];
  const auto ab = [&](std::size_t i) { return y[2 + i]; };
  const auto ba = [&](std::size_t i) { return y[2 + k + i]; };
  sums[Terms::kSum] = a + b;
  sums[Terms::kSquares] = a * a + b * b;
  for (std::size_t i = 0; i < k; ++i) {
    sums[terms.first(i)] = b * (ab(i) - a);
    sums[terms.total(i)] = 0.5 * (a - ab(i)) * (a - ab(i));
    if (terms.pairs() == 0) continue;
    sums[terms.first(i)] = 0.5 * (sums[terms.first(i)] + a * (ba(i) - b));
    sums[terms.total(i)] = 0.5 * (sums[terms.total(i)] + 0.5 * (b - ba(i)) * (b - ba(i)));
  }
  if (terms.pairs() == 0) return;
  std::size_t number = 0;
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = i + 1; j < k; ++j) {
      sums[terms.pair(number++)] = 0.5 * (ba(i) * ab(j) + ba(j) * ab(i)) - a * b;
    }
  }
}

/// Adds those of one block of many.
void addBlock(const std::vector<double>& blocks, std::size_t block, std::vector<double>& sums) {
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += blocks[block * sums.size() + i];
}

double varianceOf(const std::vector<double>& sums, double blocks) {
  const double mean = sums[Terms::kSum] / (2.0 * blocks);
  return sums[Terms::kSquares] / (2.0 * blocks) - mean * mean;
}

/// Indices from sums over blocks: first and total of each factor, then of the pairs alone.
std::vector<double> indicesOf(const std::vector<double>& sums, const Terms& terms, double blocks, double variance) {
  std::vector<double> indices;
  for (std::size_t i = 2; i < sums.size(); ++i) indices.push_back(sums[i] / blocks / variance);
  std::size_t number = terms.pair(0) - 2;
  if (terms.pairs() == 0) return indices;
  for (std::size_t i = 0; i < terms.factors; ++i) {
    for (std::size_t j = i + 1; j < terms.factors; ++j) indices[number++] -= indices[2 * i] + indices[2 * j];
  }
  return indices;
}

Estimate intervalOf(double value, std::vector<double>& repeated) {
  if (repeated.empty()) return {value, value, value};
  std::sort(repeated.begin(), repeated.end());
  const auto at = [&](double share) {
    return repeated[static_cast<std::size_t>(std::lround(share * static_cast<double>(repeated.size() - 1)))];
  };
  return {value, at(0.025), at(0.975)};
}

/// Fills the indices and their intervals.
/// @param blocks  (result.blocks x terms.size())   @param sums  of all of them
void estimate(const std::vector<double>& blocks, const Terms& terms, const std::vector<double>& sums,
              const SensitivityChoice& choice, SensitivityResult& result) {
  const auto count = static_cast<double>(result.blocks);
  const std::vector<double> values = indicesOf(sums, terms, count, result.variance);
  std::vector<std::vector<double>> repeated(values.size());
  for (std::size_t repetition = 0; repetition < choice.repetitions; ++repetition) {
    std::vector<double> drawn(terms.size(), 0.0);
    for (std::size_t i = 0; i < result.blocks; ++i) {
      addBlock(blocks, countedRandom(choice.seed, repetition, i) % result.blocks, drawn);
    }
    const double variance = varianceOf(drawn, count);
    if (!(variance > 0.0)) continue;
    const std::vector<double> again = indicesOf(drawn, terms, count, variance);
    for (std::size_t i = 0; i < again.size(); ++i) repeated[i].push_back(again[i]);
  }
  std::vector<Estimate> estimates;
  for (std::size_t i = 0; i < values.size(); ++i) estimates.push_back(intervalOf(values[i], repeated[i]));
  for (std::size_t i = 0; i < terms.factors; ++i) result.indices.push_back({estimates[2 * i], estimates[2 * i + 1]});
  std::size_t number = 2 * terms.factors;
  for (std::size_t i = 0; i < terms.factors && terms.pairs() > 0; ++i) {
    for (std::size_t j = i + 1; j < terms.factors; ++j) result.pairs.push_back({i, j, estimates[number++]});
  }
}

}  // namespace

SensitivityResult sensitivityOf(std::span<const double> values, std::size_t factors, const SensitivityChoice& choice) {
  const std::size_t members = saltelliMembers(factors, choice.order);
  if (factors == 0 || values.size() % members != 0) {
    throw std::invalid_argument("sensitivityOf: values must be whole blocks of a Saltelli plan, factors >= 1");
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

  const Terms terms{factors, choice.order};
  std::vector<double> of_blocks(whole.size() * terms.size());
  std::vector<double> sums(terms.size(), 0.0);
  std::vector<double> centred(members);
  for (std::size_t block = 0; block < whole.size(); ++block) {
    for (std::size_t i = 0; i < members; ++i) centred[i] = values[whole[block] * members + i] - result.mean;
    writeTerms(centred, terms, std::span(of_blocks).subspan(block * terms.size(), terms.size()));
    addBlock(of_blocks, block, sums);
  }
  result.variance = std::max(0.0, varianceOf(sums, blocks));
  // What rounding leaves of a constant is no variance.
  constexpr double kRounding = 1e-24;
  if (whole.size() < 2 || !(result.variance > kRounding * result.mean * result.mean)) return result;
  estimate(of_blocks, terms, sums, choice, result);
  return result;
}

}  // namespace vehicle
