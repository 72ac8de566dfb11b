#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/suite.h"
#include "libvehicle/definition/vehicle.h"
#include "libvehicle/simulate/simulate.h"
#include "libvehicle/validation/agreement.h"

namespace vehicle {

/// A method of the flat form shared among threads: a column of its own.
struct SharedColumn {
  std::string method;
  std::string scheme;
  int threads = 1;  // fewer where the vehicle has fewer equations
  std::string map;  // "paper" falls back to "auto" where the vehicle is not that of the paper
};
/// The source paper's four threads; halo and pipeline on two; exact by rows on two; bounce and pitch apart on two.
[[nodiscard]] const std::vector<SharedColumn>& usualSharedColumns();

/// Which forms and methods are set against each other, and with which settings.
struct ValidationChoice {
  std::vector<std::string> forms;    // empty: all but the printed variants
  std::vector<std::string> methods;  // empty: all, bounce and pitch apart where the vehicle is symmetric
  RunChoice run;                     // speed, step and tolerances of every run; form, method, refine and threads are
                                     // not read
  std::vector<SharedColumn> shared = usualSharedColumns();  // each beside its serial run, where that is run
  // [s] that a shared run may last, and as much again for every 10 000 steps. Four threads on two cores that other
  // programs keep busy take milliseconds a step, 500 times what they take in peace: such a run is left out, with a
  // note.
  double patience = 1.0;
};

struct ValidationRun {
  RunKey key;
  Statistics statistics;
  double wall_seconds = 0.0;
  std::optional<double> order;  // rk4 at half the step: log2 of the ratio of the errors, seen against `exact`
  std::string map = "auto";     // who computes which equation, of a run shared among threads
  std::string failure;          // why it has no result; empty if it has one
};

/// A form that cannot represent the vehicle (method empty), or a method that cannot integrate the form.
struct Misfit {
  std::string form;
  std::string method;
  std::string reason;
};

/// One vehicle on one track at one speed: all runs, all pairs.
struct ValidationReport {
  std::string vehicle;
  std::string scenario;
  double speed = 0.0;               // [m/s]
  std::vector<ValidationRun> runs;  // number 0 is the reference: the exact solution of the matrix form
  std::vector<Misfit> misfits;
  std::vector<std::string> notes;
  std::vector<PairAgreement> pairs;  // of every two runs; those with the reference first
  bool stopped = false;              // ended early on request: pairs of the finished runs only

  /// Every run finished, at least one pair was judged, and none is outside.
  [[nodiscard]] bool inside() const;
  [[nodiscard]] std::size_t count(Verdict verdict) const;
};

/// Called now and then with the share done, 0..1, and what is going on; returning false ends the work.
using ValidationProgress = std::function<bool(double share, const std::string& what)>;

/// Runs every form by every method that fits and compares all pairs by the tolerance ledger (ledger.h).
///
/// The exact solution of the matrix form is always there as the reference, and each rk4 run brings one at half the
/// step, whose error must have fallen as order 4 demands. A run shared among threads must have the bits of its serial
/// one. A chosen form that no chosen method can integrate
/// is run by its default method, with a note.
/// @throws InvalidInput           vehicle or scenario is wrong
/// @throws std::invalid_argument  a form or method that does not exist, a wrong setting, or histories that together
///                                would need more than 2 GiB
[[nodiscard]] ValidationReport validate(const Vehicle& vehicle, const Scenario& scenario,
                                        const ValidationChoice& choice = {}, const ValidationProgress& progress = {});

/// One case of a suite.
struct ValidationCase {
  std::size_t vehicle = 0;      // number in the suite's vehicles
  std::size_t scenario = 0;     // number in the suite's scenarios
  std::optional<double> speed;  // [m/s]; none: the scenario's own
};

/// The suite's vehicles, scenarios and speeds crossed, speeds fastest; forms and methods are crossed inside each.
[[nodiscard]] std::vector<ValidationCase> casesOf(const Suite& suite);
/// `choice` with the suite's forms and methods, where it names any.
[[nodiscard]] ValidationChoice choiceOf(const Suite& suite, ValidationChoice choice = {});

}  // namespace vehicle
