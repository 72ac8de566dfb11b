#include "libvehicle/excitation/travel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace vehicle {

Travel::Travel(double speed, std::span<const Phase> phases) {
  if (!(speed > 0.0 && std::isfinite(speed))) {
    throw std::invalid_argument(fmt::format("travel: speed = {} m/s, must be finite and > 0", speed));
  }
  Stage stage{0.0, 0.0, speed, 0.0};
  for (const Phase& phase : phases) {
    stage.acceleration = phase.acceleration;
    const double gained = phase.acceleration * phase.duration;
    double reached = stage.speed + gained;
    // A stop lasts as long as its deceleration says, which rounding may miss by a bit.
    if (std::abs(reached) <= 1e-12 * stage.speed) reached = 0.0;
    if (!(phase.duration > 0.0 && std::isfinite(phase.duration) && reached >= 0.0 && std::isfinite(reached))) {
      throw std::invalid_argument(
          fmt::format("travel: {} m/s^2 for {} s from {} m/s on; must last longer than 0 s and end at 0 m/s or more",
                      phase.acceleration, phase.duration, stage.speed));
    }
    stages_.push_back(stage);
    stage = {stage.begin + phase.duration, stage.distance + (stage.speed + 0.5 * gained) * phase.duration, reached,
             0.0};
  }
  stages_.push_back(stage);
}

const Travel::Stage& Travel::stageAt(double t) const {
  const auto after = std::upper_bound(stages_.begin() + 1, stages_.end(), t,
                                      [](double instant, const Stage& stage) { return instant < stage.begin; });
  return *(after - 1);
}

double Travel::distance(double t, double behind) const {
  const Stage& stage = stageAt(t);
  if (isUniform()) return std::fma(stage.speed, t, -behind);
  const double since = t - stage.begin;
  const double gained = since > 0.0 ? 0.5 * stage.acceleration * since : 0.0;
  return stage.distance + (stage.speed + gained) * since - behind;
}

double Travel::speed(double t) const {
  const Stage& stage = stageAt(t);
  return stage.speed + stage.acceleration * std::max(0.0, t - stage.begin);
}

double Travel::acceleration(double t) const { return t < 0.0 ? 0.0 : stageAt(t).acceleration; }

double Travel::time(double s) const {
  if (isUniform() || s <= 0.0) return s / stages_.front().speed;
  if (std::isinf(s)) return s;
  const auto after = std::upper_bound(stages_.begin(), stages_.end(), s,
                                      [](double place, const Stage& stage) { return place <= stage.distance; });
  const Stage& stage = *(after - 1);
  const double way = s - stage.distance;
  // Of the two roots of way = v d + a d^2 / 2 the first, without a difference of equal numbers.
  const double square = stage.speed * stage.speed + 2.0 * stage.acceleration * way;
  const double mean_speed = 0.5 * (stage.speed + std::sqrt(std::max(0.0, square)));
  return mean_speed > 0.0 ? stage.begin + way / mean_speed : std::numeric_limits<double>::infinity();
}

double Travel::fastest() const {
  double fastest = 0.0;
  for (const Stage& stage : stages_) fastest = std::max(fastest, stage.speed);
  return fastest;
}

std::vector<double> Travel::jumps() const {
  std::vector<double> instants;
  for (std::size_t i = 1; i < stages_.size(); ++i) instants.push_back(stages_[i].begin);
  return instants;
}

}  // namespace vehicle
