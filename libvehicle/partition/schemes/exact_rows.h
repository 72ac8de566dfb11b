#pragma once

// The exact propagator, row by row: x(s + h) of a row needs the whole x(s), so every thread shows its rows to all
// others once a step. One exchange of one line in place of four, but each thread waits for all.

#include "libvehicle/partition/run.h"

namespace vehicle {

/// Exact propagation with the rows of the propagator shared as the equations are, the bits of runExact().
/// Every thread makes the propagators for itself: they are few, and matrices that nobody shares need no exchange.
/// @throws as runPartitioned(); std::invalid_argument if system.linear() is empty
PartitionRun runExactRows(const System& system, const Input& input, const Schedule& schedule,
                          std::span<const double> x0, const Observer& observe, const PartitionChoice& choice);

}  // namespace vehicle
