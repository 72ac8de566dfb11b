#pragma once

#include "apps/cli/document.h"
#include "libvehicle/model/rest.h"
#include "libvehicle/model/topology.h"

namespace vehicle::cli {

// What `vehicle info` tells of a vehicle, one table a subject.

/// The vehicles of a train: title, place, mass, static load on the rail.
[[nodiscard]] Table unitTable(const Vehicle& train, const Topology& topology, const Rest& rest);
/// Mass, inertia, place, motions, how far the body has come down at rest.
[[nodiscard]] Table bodyTable(const Vehicle& vehicle, const Topology& topology, const Rest& rest);
/// Place, mass, static load and how far that is from the mean of its vehicle, where the loads differ; how it meets the
/// rail.
[[nodiscard]] Table wheelsetTable(const Topology& topology, const Rest& rest);
/// Ends, place, both sides' stiffness and damping, static load, how far that compresses it.
[[nodiscard]] Table suspensionTable(const Topology& topology, const Rest& rest);
/// Which forms fit.
[[nodiscard]] Table formTable(const Topology& topology);
/// Why the others do not, one line a reason with the forms that give it.
[[nodiscard]] Table misfitTable(const Topology& topology);
/// What the planar forms do not use: kept in the file for the vehicle in three dimensions.
[[nodiscard]] Table unusedTable(const Vehicle& vehicle);
/// The same in one line for people: "not used by the planar forms: y of 12 parts, roll_inertia of carbody".
[[nodiscard]] std::string unusedLine(const Table& unused);

}  // namespace vehicle::cli
