#include "libvehicle/system/mixed_input.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace vehicle {
namespace {

// @param rows  (channels x n), row-major   @return  (weights.size() / channels x n), row-major
std::vector<double> mixedRows(const std::vector<double>& rows, std::span<const double> weights, std::size_t channels) {
  const std::size_t n = rows.size() / channels;
  std::vector<double> mixed(weights.size() / channels * n, 0.0);
  for (std::size_t at = 0; at < weights.size(); ++at) {
    if (weights[at] == 0.0) continue;
    const double* from = rows.data() + at % channels * n;
    double* to = mixed.data() + at / channels * n;
    for (std::size_t k = 0; k < n; ++k) to[k] += weights[at] * from[k];
  }
  return mixed;
}

}  // namespace

Input mixedInput(const Input& input, std::span<const double> weights) {
  const auto channels = static_cast<std::size_t>(input.channels());
  if (weights.empty() || weights.size() % channels != 0) {
    throw std::invalid_argument("mixedInput: " + std::to_string(weights.size()) + " weights, must be whole rows of " +
                                std::to_string(channels) + ", one a channel of the input");
  }
  const auto bad = std::find_if_not(weights.begin(), weights.end(), [](double w) { return std::isfinite(w); });
  if (bad != weights.end()) {
    throw std::invalid_argument("mixedInput: weights[" + std::to_string(bad - weights.begin()) +
                                "] = " + std::to_string(*bad) + ", must be finite");
  }
  std::vector<InputSegment> segments;
  segments.reserve(static_cast<std::size_t>(input.segments()));
  for (int index = 0; index < input.segments(); ++index) {
    const InputSegment& from = input.segment(index);
    InputSegment mixed;
    mixed.begin = from.begin;
    mixed.end = from.end;
    mixed.angular_frequency = from.angular_frequency;
    mixed.cosine = mixedRows(from.cosine, weights, channels);
    mixed.sine = mixedRows(from.sine, weights, channels);
    mixed.polynomial = mixedRows(from.polynomial, weights, channels);
    for (const SampledTerm& term : from.sampled) {
      for (std::size_t row = 0; row < weights.size() / channels; ++row) {
        const double weight = weights[row * channels + static_cast<std::size_t>(term.channel)];
        if (weight != 0.0) mixed.sampled.push_back({static_cast<int>(row), weight * term.weight, term.motion});
      }
    }
    segments.push_back(std::move(mixed));
  }
  return Input(static_cast<int>(weights.size() / channels), std::move(segments));
}

}  // namespace vehicle
