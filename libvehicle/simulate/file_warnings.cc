#include "libvehicle/simulate/file_warnings.h"

#include <algorithm>
#include <utility>

#include "libvehicle/linear/motion_rates.h"
#include "libvehicle/matrix/matrix_form.h"
#include "libvehicle/model/geometry_warnings.h"
#include "libvehicle/model/rest.h"
#include "libvehicle/simulate/vehicle_warnings.h"

namespace vehicle {

namespace {

/// Whether another one says the same: of an equal vehicle of a train, or of the reason.
bool isSaid(const Warning& warning, const Warnings& others) {
  return std::any_of(others.begin(), others.end(), [&](const Warning& other) {
    const bool same_place =
        warning.place.line > 0 && other.place.line == warning.place.line && other.place.file == warning.place.file;
    if (other.code == warning.code) return same_place;
    // "b1 pitch" or "b1 bounce", whichever coordinate leads.
    return warning.code == WarningCode::kFreeMode && other.code == WarningCode::kFreePitch &&
           (same_place || warning.subject.starts_with(other.subject + ' '));
  });
}

}  // namespace

Warnings fileWarnings(const CompiledModel& model) {
  Warnings warnings = geometryWarnings(model.vehicle, model.topology, model.rest);
  for (Warning& each : restWarnings(model)) {
    if (!isSaid(each, warnings)) warnings.push_back(std::move(each));
  }
  const bool stands = std::none_of(warnings.begin(), warnings.end(),
                                   [](const Warning& each) { return each.code == WarningCode::kCannotStand; });
  const Warnings moving = motionWarnings(MotionRates(*buildMatrixForm(model)), stands);
  warnings.insert(warnings.end(), moving.begin(), moving.end());
  return warnings;
}

}  // namespace vehicle
