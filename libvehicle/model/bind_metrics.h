#pragma once

#include "libvehicle/model/bound_study.h"

namespace vehicle {

/// The second half of bindStudy(): metrics looked up among the columns, suspensions and wheelsets of the vehicle, then
/// the objectives and limits on them. Private to this room.
/// @param bound     with its cases; gets metrics, objectives and limits
/// @param problems  of the first half; objectives and limits of a metric that is wrong are left out
void bindMetrics(const Study& study, const Vehicle& vehicle, BoundStudy& bound, ProblemList& problems);

}  // namespace vehicle
