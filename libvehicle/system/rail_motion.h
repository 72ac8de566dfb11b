#pragma once

#include <memory>
#include <span>

namespace vehicle {

/// The rail under one wheelset at one instant.
struct RailState {
  double height = 0.0;        // eta [m]
  double rate = 0.0;          // eta' [m/s]
  double acceleration = 0.0;  // eta'' [m/s^2]
};

/// What the rail does under one wheelset over time where that has no closed form: between samples of a measured rail, or
/// under a vehicle whose speed changes. Height and rate are continuous as long as a segment of the input lasts.
/// One object serves any number of threads.
class RailMotion {
 public:
  virtual ~RailMotion() = default;

  /// @param t  [s] as many as states; quickest where they ascend
  virtual void evaluate(std::span<const double> t, std::span<RailState> states) const = 0;
  /// [rad/s] of the fastest motion in it: what samples and steps have to follow; > 0.
  [[nodiscard]] virtual double fastest() const = 0;
};

/// weight times the motion, under that channel. Motions are shared: an input is copied, reordered and mixed, and each of
/// these reads the same rail.
struct SampledTerm {
  int channel = 0;
  double weight = 1.0;
  std::shared_ptr<const RailMotion> motion;
};

}  // namespace vehicle
