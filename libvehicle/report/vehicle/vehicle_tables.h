#pragma once

#include "libvehicle/report/document/document.h"
#include "libvehicle/simulate/vehicle_figures.h"

namespace vehicle::report {

/// What a vehicle or train is called, its figures, its parts, and which forms can compute it.
[[nodiscard]] Document documentOf(const CompiledModel& model, const VehicleFigures& figures, Format format);

// Its tables, one a subject.

/// The vehicles of a train: title, place, mass, static load on the rail.
[[nodiscard]] Table unitTable(const CompiledModel& train);
/// Mass, inertia, place, motions, how far the body has come down at rest.
[[nodiscard]] Table bodyTable(const CompiledModel& model);
/// Place, mass, static load and how far that is from the mean of its vehicle, where the loads differ; how it meets the
/// rail.
[[nodiscard]] Table wheelsetTable(const CompiledModel& model, const VehicleFigures& figures);
/// Ends, place, both sides' stiffness and damping, static load, how far that compresses it.
[[nodiscard]] Table suspensionTable(const CompiledModel& model);
/// Undamped frequency and damping ratio of bounce and pitch of the carbody.
[[nodiscard]] Table carbodyTable(const VehicleFigures& figures);
/// Which forms fit.
[[nodiscard]] Table formTable(const Topology& topology);
/// Why the others do not, one line a reason with the forms that give it.
[[nodiscard]] Table unsupportedTable(const Topology& topology);
/// What the planar forms do not use: kept in the file for the vehicle in three dimensions.
[[nodiscard]] Table unusedTable(const Vehicle& vehicle);
/// The same in one line for people: "not used by the planar forms: y of 12 parts, roll_inertia of carbody".
[[nodiscard]] std::string unusedLine(const Table& unused);

}  // namespace vehicle::report
