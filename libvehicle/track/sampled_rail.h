#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "libvehicle/track/rail_point.h"
#include "libvehicle/track/rail_samples.h"

namespace vehicle {

/// Where samples of a rail lie.
struct SampleGridOverDistance {
  double begin = 0.0;    // [m] of the first sample
  double spacing = 0.0;  // [m] > 0
};

/// The rail through equally spaced samples: the cubic spline, whose height, slope and curvature are continuous.
///
/// Pieces are made where a wheel comes to them and forgotten behind it, kBlock samples at a time, so memory is
/// kSlots blocks (1 MB) whatever the length, and nothing passes before the first step. The slopes of a block follow from
/// its own samples and kReach more on either side: what lies farther off weighs (2 - sqrt 3)^kReach = 5e-19, so blocks join
/// to rounding. Which block holds a distance is fixed by the grid, so no value depends on who reads first.
/// Error for a smooth rail z(s) with samples d apart: height d^4 |z''''| / 384, slope d^3 |z''''| / 125; a wave of
/// fewer than four samples is not followed.
/// Beyond an end the last cubic goes on: who reads there by rounding gets the one-sided limit.
/// One object serves any number of threads.
/// Source: C. de Boor, A Practical Guide to Splines, rev. ed., ch. IV.
class SampledRail {
 public:
  static constexpr std::int64_t kBlock = 1024;
  static constexpr std::int64_t kReach = 32;
  static constexpr std::size_t kSlots = 64;  // all wheels of a train within 64 blocks: 16 km at 0.25 m

  /// @throws std::invalid_argument unless there are two samples or more, and begin and spacing > 0 are finite
  SampledRail(std::shared_ptr<RailSamples> samples, SampleGridOverDistance grid);
  ~SampledRail();

  [[nodiscard]] double begin() const { return grid_.begin; }  // [m]
  [[nodiscard]] double end() const;                           // [m]
  /// [rad/m] of the fastest wave that the spline follows: one of four samples.
  [[nodiscard]] double fastestWave() const;

  /// A piece of it that is at hand; neighbouring distances are read from it without looking for another.
  struct Block;
  using Held = std::shared_ptr<const Block>;
  /// @param held  the block of the reader's last distance, or none; becomes the one of this
  /// @throws what reading the samples throws; std::runtime_error for a height that is not finite, naming its distance
  [[nodiscard]] RailPoint at(double s, Held& held) const;
  [[nodiscard]] RailPoint at(double s) const {
    Held held;
    return at(s, held);
  }

 private:
  struct Slot {
    std::mutex changing;
    Held block;
  };
  [[nodiscard]] Held blockOf(std::int64_t number) const;
  [[nodiscard]] Held makeBlock(std::int64_t number) const;

  // Shared with who made them: a rail is read by every wheel and every thread of a run.
  std::shared_ptr<RailSamples> samples_;
  SampleGridOverDistance grid_;
  std::int64_t intervals_;
  mutable std::mutex reading_;
  mutable std::vector<Slot> slots_;  // block b stands in slot b mod kSlots
};

}  // namespace vehicle
