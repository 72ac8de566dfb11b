#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libvehicle/definition/origin.h"
#include "libvehicle/definition/vehicle.h"

namespace vehicle {

// A train as the user said it: files of vehicles that follow each other, the leading one first, and the couplings
// between them. assembled() makes one Vehicle of it, which every form and command then takes as any other.

/// Equal vehicles that follow each other.
struct TrainVehicle {
  std::string file;             // as written; relative names count from the folder of the train's file
  std::string name;             // what they are called in results; "": as the vehicle calls itself
  int count = 1;                // >= 1
  double spacing = 0.0;         // [m] > 0 length of track that each of them takes: its origin is in the middle of that
  std::optional<double> end_x;  // [m] > 0 its ends before and behind the CG of its carbody; else as the coupling says
  Vehicle vehicle;              // what the file holds; without bodies: it has not been read
  Origin origin;
  bool operator==(const TrainVehicle&) const = default;
};

/// A vertical spring and damper from the rear end of a carbody to the front end of the next one. It is fitted at rest:
/// it carries no static load.
struct Coupling {
  double stiffness_z = 0.0;     // [N/m]    >= 0
  double damping_z = 0.0;       // [N s/m]  >= 0
  std::optional<double> end_x;  // [m] > 0 ends of the vehicles that do not say so themselves
  std::optional<double> z;      // [m] height above rail top; else that of each carbody's CG
  Origin origin;
  bool operator==(const Coupling&) const = default;
};

struct Train {
  /// More cannot be meant, and their results would not fit anywhere.
  static constexpr int kMostVehicles = 10'000;

  std::string name;
  std::string title;
  std::string source;
  std::vector<TrainVehicle> vehicles;  // the leading one first
  std::vector<Coupling> couplings;     // one: between all neighbours; one fewer than vehicles: front to rear; or none
  Origin origin;
  bool operator==(const Train&) const = default;
};

/// Number of vehicles in the train.
[[nodiscard]] long vehiclesOf(const Train& train);

/// All contradictions: those of the train's own values, those of the vehicles as far as they have been read, and those
/// between the two (a coupling on a vehicle without one carbody, vehicles that stand into each other, heights given
/// for some vehicles only, ...).
[[nodiscard]] ProblemList check(const Train& train);

/// The body on top of the others: the only one that no suspension has below it. Index into vehicle.bodies; -1: there is
/// none, or more than one.
[[nodiscard]] int carbodyOf(const Vehicle& vehicle);

/// The train as one vehicle. Unit k (1 leads) is called NAME_k and its parts NAME_k.PART; the leading vehicle keeps its
/// x, each other one stands half its spacing and half that of the one ahead behind that. Coupling k is the suspension
/// "coupling_k" from the carbody of unit k (upper) to that of unit k + 1 (lower), at their ends, with a preload of 0.
/// The parts keep their places in the vehicles' files.
/// @throws InvalidInput with check()'s problems, or if a vehicle has not been read
[[nodiscard]] Vehicle assembled(const Train& train);

}  // namespace vehicle
