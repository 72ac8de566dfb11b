#pragma once

#include <memory>
#include <span>
#include <utility>

#include "libvehicle/excitation/travel.h"
#include "libvehicle/system/rail_motion.h"
#include "libvehicle/track/rail_piece.h"

namespace vehicle {

/// What one wheelset meets of a piece of rail while it is on it: with s = s(t) - behind,
///     eta = z(s),   eta' = z'(s) s',   eta'' = z''(s) s'^2 + z'(s) s''
class WheelOnRail final : public RailMotion {
 public:
  /// @param behind  [m] the leading wheelset
  /// Piece and travel are shared by all wheels, and by the inputs that look at them.
  WheelOnRail(std::shared_ptr<const RailPiece> piece, std::shared_ptr<const Travel> travel, double behind)
      : piece_(std::move(piece)), travel_(std::move(travel)), behind_(behind) {}

  void evaluate(std::span<const double> t, std::span<RailState> states) const override;
  [[nodiscard]] double fastest() const override { return piece_->fastestWave() * travel_->fastest(); }

 private:
  std::shared_ptr<const RailPiece> piece_;
  std::shared_ptr<const Travel> travel_;
  double behind_;
};

}  // namespace vehicle
