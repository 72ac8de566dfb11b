#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace vehicle {

// Harmonics with a common period: what extremes and percentiles of a steady state are sampled over.

/// Largest order that is looked for.
inline constexpr int kMostOrder = 200;

/// Orders n_f of w_f = n_f w_0 with the largest w_0 that fits, so that 2 pi / w_0 is the common period; nothing where
/// an order would exceed kMostOrder. Frequencies count as multiples within 1e-9 of themselves.
/// @param angular_frequency  [rad/s] (F) > 0
[[nodiscard]] std::optional<std::vector<int>> harmonicOrders(std::span<const double> angular_frequency);

/// cos and sin of n_f x at x = 2 pi i / samples, over one common period.
/// @param orders        (F)
/// @param zeros_before  pairs of zeros ahead of them, for parts of a motion that are not to be counted
/// @returns (samples x (zeros_before + F) x 2)
[[nodiscard]] std::vector<double> circleOf(std::span<const int> orders, int samples, std::size_t zeros_before = 0);

}  // namespace vehicle
