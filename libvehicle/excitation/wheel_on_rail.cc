#include "libvehicle/excitation/wheel_on_rail.h"

namespace vehicle {

void WheelOnRail::evaluate(std::span<const double> t, std::span<RailState> states) const {
  SampledRail::Held held;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const RailPoint rail = piece_->at(travel_->distance(t[i], behind_), held);
    const double speed = travel_->speed(t[i]);
    states[i] = {rail.height, rail.slope * speed,
                 rail.curvature * speed * speed + rail.slope * travel_->acceleration(t[i])};
  }
}

}  // namespace vehicle
