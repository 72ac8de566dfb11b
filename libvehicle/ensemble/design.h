#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "libvehicle/flat/flat_layout.h"
#include "libvehicle/flat/flat_model.h"
#include "libvehicle/model/topology.h"

namespace vehicle {

/// Measuring points on the carbody that a design can carry.
inline constexpr int kMostPoints = 8;

/// One design of an ensemble: the numbers of a 4-DOF vehicle and how it starts. Parts count from the front, as
/// in FlatParameters; wheels 1 to 4 read the channels 0 to 3 of the input.
struct EnsembleDesign {
  FlatParameters vehicle;
  std::array<double, 8> start{};                // (zk, phi, z1, z2, zk', phi', z1', z2') at the first sample
  std::array<double, 4> wheel_load{};           // [N] static wheel-rail force Q0
  std::array<double, 4> wheelset_mass{};        // [kg] of wheelsets that follow the rail
  std::array<double, kMostPoints> point_arm{};  // [m] measuring points ahead of the carbody's centre of gravity
};

/// Beyond that the linear equations do not hold (LARGE_MOTION): carbody pitch [rad], travel of a suspension [m].
inline constexpr double kMostFlatPitch = 0.1;
inline constexpr double kMostFlatTravel = 0.5;

/// Any column of a result of the flat form, parts counted from the front. The measuring points on the carbody follow:
/// pointColumn().
enum class FlatColumn : int {
  kCarbodyZ, kCarbodyPitch, kCarbodyVz, kCarbodyPitchRate, kCarbodyAz, kCarbodyPitchAcc,
  kFrontBogieZ, kFrontBogieVz, kFrontBogieAz,
  kRearBogieZ, kRearBogieVz, kRearBogieAz,
  kSecondaryFrontDeflection, kSecondaryFrontForce, kSecondaryRearDeflection, kSecondaryRearForce,
  kPrimary1Deflection, kPrimary1Force, kPrimary2Deflection, kPrimary2Force,
  kPrimary3Deflection, kPrimary3Force, kPrimary4Deflection, kPrimary4Force,
  kWheel1RailZ, kWheel1Load, kWheel2RailZ, kWheel2Load, kWheel3RailZ, kWheel3Load, kWheel4RailZ, kWheel4Load,
  kFirstPoint,
};

enum class PointQuantity : int { kZ, kVz, kAz };

/// Column of a measuring point on the carbody.
/// @param point  0 .. kMostPoints - 1, index into point_arm
[[nodiscard]] constexpr FlatColumn pointColumn(int point, PointQuantity quantity) {
  return static_cast<FlatColumn>(static_cast<int>(FlatColumn::kFirstPoint) + 3 * point + static_cast<int>(quantity));
}
inline constexpr int kFlatColumns = static_cast<int>(FlatColumn::kFirstPoint) + 3 * kMostPoints;

/// The design of a vehicle that the flat form fits: parameters, static loads, wheelset masses, and the arms of its
/// measuring points on the carbody, in file order. It starts at rest on level rail.
/// @param layout  readLayout(topology).layout, whole
/// @throws InvalidInput if the springs cannot carry the weight, as restOf() says
[[nodiscard]] EnsembleDesign ensembleDesign(const Topology& topology, const FlatLayout& layout, double gravity);

/// The column that a result of that vehicle calls `name`, e.g. "carbody.az" or "secondary_front.deflection"; nothing
/// where it has none of that name, and for a measuring point on the carbody beyond the first kMostPoints.
[[nodiscard]] std::optional<FlatColumn> flatColumn(const Topology& topology, const FlatLayout& layout,
                                                   std::string_view name);

}  // namespace vehicle
