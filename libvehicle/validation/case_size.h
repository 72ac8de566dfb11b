#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "libvehicle/definition/topology.h"
#include "libvehicle/result/time_history.h"
#include "libvehicle/statics/rest.h"
#include "libvehicle/system/input.h"
#include "libvehicle/validation/geometry.h"
#include "libvehicle/validation/sensitivity.h"

namespace vehicle {

/// A vehicle on its track as the ledger sees it. One serves all forms of the same linear equations.
struct CaseSize {
  Topology topology;
  Rest rest;
  Sensitivity sensitivity;
  MotionSize motion;               // of the reference run
  Eigen::VectorXd input_rounding;  // (2 w) [m, m/s] what the input sweeps of a fixed-step run may round
  std::vector<Channel> columns;    // (outputs)
  double duration = 0.0;           // [s]
  double output_step = 0.0;        // [s]
};

/// @param system     the linear form whose equations the runs have
/// @param reference  a history of these equations, samples close enough to show its peaks
/// @param output_step  [s] of the runs that are judged
[[nodiscard]] CaseSize sizeOfCase(const System& system, Topology topology, Rest rest, const Input& input,
                                  const TimeHistory& reference, double output_step);

/// Place of a column of that name, if there is one.
[[nodiscard]] std::optional<Eigen::Index> columnOf(const std::vector<Channel>& columns, const std::string& name);
/// The column whose time derivative this acceleration is: "carbody.az" -> that of "carbody.vz".
[[nodiscard]] std::optional<Eigen::Index> velocityOf(const std::vector<Channel>& columns, const std::string& name);

}  // namespace vehicle
