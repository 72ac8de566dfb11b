#include "libvehicle/system/sample_weights.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace vehicle {
namespace {

/// Adds, to the weights of the nodes, those of the integral from a to b of the polynomial through them.
/// @param nodes  at most 4
void addPolynomial(std::span<const double> nodes, double a, double b, std::span<double> weights) {
  // Two Gauss points integrate a cubic exactly.
  const double middle = 0.5 * (a + b);
  const double half = 0.5 * (b - a);
  for (const double x : {middle - half / std::sqrt(3.0), middle + half / std::sqrt(3.0)}) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      double basis = half;
      for (std::size_t j = 0; j < nodes.size(); ++j) {
        if (j != i) basis *= (x - nodes[j]) / (nodes[i] - nodes[j]);
      }
      weights[i] += basis;
    }
  }
}

/// What Gregory's formula takes off the weight 1 of the samples at an end.
constexpr double kGregory[] = {251.0 / 720.0 - 1.0, 897.0 / 720.0 - 1.0, 633.0 / 720.0 - 1.0, 739.0 / 720.0 - 1.0};

/// Weights of few samples, one by one.
std::vector<double> allWeights(const std::vector<double>& nodes, bool odd_first, bool odd_last) {
  const std::size_t n = nodes.size() - 1;
  std::vector<double> weights(n + 1, 0.0);
  const std::span<const double> all(nodes);
  if (n <= 3) {
    addPolynomial(all, nodes.front(), nodes.back(), weights);
    return weights;
  }
  const std::size_t first = odd_first ? 1 : 0;
  const std::size_t last = odd_last ? n - 1 : n;
  if (odd_first) addPolynomial(all.first(4), nodes[0], nodes[1], std::span(weights).first(4));
  if (odd_last) addPolynomial(all.last(4), nodes[n - 1], nodes[n], std::span(weights).last(4));
  const std::size_t count = last - first;
  if (count < 3) {
    addPolynomial(all.subspan(first, count + 1), nodes[first], nodes[last],
                  std::span(weights).subspan(first, count + 1));
    return weights;
  }
  const double step = (nodes[last] - nodes[first]) / static_cast<double>(count);
  for (std::size_t i = first; i <= last; ++i) weights[i] += step;
  for (std::size_t i = 0; i < 4; ++i) {
    weights[first + i] += step * kGregory[i];
    weights[last - i] += step * kGregory[i];
  }
  return weights;
}

// At either end an odd interval reaches four samples in, Gregory's formula behind it four more.
constexpr std::size_t kEnd = 5;

}  // namespace

SampleWeights::SampleWeights(std::size_t intervals, double first, double point_step, double last)
    : intervals_(intervals), point_step_(point_step) {
  const auto isOdd = [&](double length) { return std::abs(length - point_step) > 1e-12 * point_step; };
  const bool odd_first = isOdd(first);
  const bool odd_last = isOdd(last);
  // The weights of many samples are those of a dozen, with equal ones put in between.
  const std::size_t few = std::min(intervals, 2 * kEnd + 2);
  std::vector<double> nodes{0.0};
  for (std::size_t i = 0; i < few; ++i) {
    nodes.push_back(nodes.back() + (i == 0 ? first : i + 1 == few ? last : point_step));
  }
  std::vector<double> weights = allWeights(nodes, odd_first && few > 1, odd_last && few > 1);
  if (few == intervals) {
    head_ = std::move(weights);
    return;
  }
  head_.assign(weights.begin(), weights.begin() + kEnd);
  tail_.assign(weights.rbegin(), weights.rbegin() + kEnd);
}

SampleWeights::SampleWeights(const Schedule& schedule, const Schedule::Part& part)
    : SampleWeights(part.count, schedule.intervals()[part.first_interval].end - part.begin,
                    schedule.outputStep() / part.cut,
                    part.end - schedule.intervals()[part.first_interval + part.count - 1].begin) {}

}  // namespace vehicle
