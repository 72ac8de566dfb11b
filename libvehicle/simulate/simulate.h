#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/vehicle.h"
#include "libvehicle/result/time_history.h"
#include "libvehicle/system/schedule.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// flat, matrix, mbs, mbs-linear, flat-7-printed, flat-literal, flat-literal-mb
[[nodiscard]] const std::vector<std::string>& formNames();
/// rk4, dopri5, exact, simbody_rkm
[[nodiscard]] const std::vector<std::string>& methodNames();

/// Why this form cannot represent the vehicle; empty if it can.
/// @throws std::invalid_argument for a form that does not exist, naming the nearest one
[[nodiscard]] ProblemList formMisfits(const std::string& form, const Vehicle& vehicle);
/// Why this method cannot integrate that form ("exact needs ...; mbs is nonlinear"); empty if it can.
[[nodiscard]] std::string methodMisfit(const std::string& method, const std::string& form);

/// @throws InvalidInput with formMisfits()
[[nodiscard]] std::unique_ptr<System> buildForm(const std::string& form, const Vehicle& vehicle, double gravity);

/// What to run and how.
struct RunChoice {
  std::string form;             // empty: flat where it fits, else matrix
  std::string method;           // empty: exact where it fits, else dopri5
  std::optional<double> speed;  // [m/s]; empty: the scenario's
  double step = 1e-3;           // [s] largest fixed step
  int refine = 1;               // cuts every fixed step once more (convergence orders)
  double relative = 1e-10;      // dopri5
  double absolute = 1e-12;      // dopri5, in the state's unit
  double accuracy = 1e-10;      // simbody_rkm
};

struct RunResult {
  TimeHistory history;
  Statistics statistics;
  std::string form;
  std::string method;
  double speed = 0.0;         // [m/s]
  double wall_seconds = 0.0;  // of the integration, outputs included, building the form excluded
};

/// Called now and then with the share done, 0..1; returning false ends the run with what there is.
using Progress = std::function<bool(double)>;

/// One run.
/// @throws InvalidInput       vehicle or scenario is wrong, or the form does not fit
/// @throws std::invalid_argument  form, method, step or tolerance is wrong
/// @throws RunFailed          NaN, or an integrator gave up; names the time
[[nodiscard]] RunResult simulate(const Vehicle& vehicle, const Scenario& scenario, const RunChoice& choice = {},
                                 const Progress& progress = {});

}  // namespace vehicle
