#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libvehicle/model/compiled_model.h"

namespace vehicle {

/// Static loads on the rail of the halves of a vehicle [N]; an axle in the middle belongs to both.
struct HalfLoads {
  double front = 0.0;
  double rear = 0.0;
};

/// A motion of the carbody by the mode in which it takes most part.
struct CarbodyMotion {
  std::string name;            // "carbody bounce"
  double frequency = 0.0;      // [Hz] undamped
  double damping_ratio = 0.0;  // [-]
};

/// The figures that an engineer checks first, of a vehicle or train at rest.
struct VehicleFigures {
  double mass = 0.0;                    // [kg]
  double unsprung_mass = 0.0;           // [kg] of the wheelsets
  double weight = 0.0;                  // [N]
  std::optional<HalfLoads> halves;      // of a vehicle whose halves differ by more than 0.05 % of the whole
  std::vector<double> load_deviations;  // [-] loadDeviations()
  std::vector<CarbodyMotion> carbody;   // bounce and pitch; none for a train, and without one body on top
};

/// Cost: the modes of one linear form.
[[nodiscard]] VehicleFigures figuresOf(const CompiledModel& model);

/// (wheel load - mean) / mean of each wheelset [-], the mean being that of its vehicle; empty where none differs by
/// more than 0.05 %.
[[nodiscard]] std::vector<double> loadDeviations(const Topology& topology, const Rest& rest);

}  // namespace vehicle
