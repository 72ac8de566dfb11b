#pragma once

#include <span>
#include <vector>

namespace vehicle {

/// Where a vehicle is on its track: the distance s(t) of its leading wheelset from s = 0, where that stands at t = 0. It
/// runs at a speed that stays, or changes at constant accelerations one after the other; it never runs backwards.
class Travel {
 public:
  /// A while of constant acceleration.
  struct Phase {
    double duration = 0.0;      // [s] > 0
    double acceleration = 0.0;  // [m/s^2]; negative: it brakes
  };

  /// Always at that speed, before t = 0 too.
  /// @param speed  [m/s] finite and > 0
  /// @throws std::invalid_argument
  explicit Travel(double speed) : Travel(speed, {}) {}
  /// From t = 0 on through the phases; behind the last it keeps its speed, or stands.
  /// @throws std::invalid_argument also for a phase that lasts no time or would end with a speed below 0
  Travel(double speed, std::span<const Phase> phases);

  [[nodiscard]] bool isUniform() const { return stages_.size() == 1; }
  /// What a wheel that is `behind` [m] the leading one reads at: s(t) - behind, rounded once at constant speed.
  [[nodiscard]] double distance(double t, double behind = 0.0) const;
  [[nodiscard]] double speed(double t) const;         // s'(t) [m/s]
  [[nodiscard]] double acceleration(double t) const;  // s''(t) [m/s^2]; where it jumps, of what begins there
  /// When the leading wheelset is at s: the first time; infinite where it never comes there.
  [[nodiscard]] double time(double s) const;
  [[nodiscard]] double fastest() const;  // [m/s] largest speed
  /// Instants > 0 at which the acceleration jumps [s].
  [[nodiscard]] std::vector<double> jumps() const;

 private:
  struct Stage {
    double begin;                          // [s]
    double distance, speed, acceleration;  // at its begin
  };
  [[nodiscard]] const Stage& stageAt(double t) const;

  std::vector<Stage> stages_;  // the first also before its begin, without acceleration
};

}  // namespace vehicle
