#pragma once

#include "libvehicle/definition/bound_study.h"

namespace vehicle {

/// The second half of bindStudy(): metrics looked up among the columns, suspensions and wheelsets of the vehicle, then
/// the objectives and limits on them. Private to this room.
/// @param bound     with its cases; gets metrics, objectives and limits
/// @param problems  of the first half; goals are looked at only where there are none
void bindMetrics(const Study& study, const Vehicle& vehicle, BoundStudy& bound, ProblemList& problems);

}  // namespace vehicle
