#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/model/compiled_model.h"
#include "libvehicle/simulate/simulate.h"
#include "libvehicle/validation/ledger.h"

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
  std::vector<double> speeds;        // [m/s] of all cases; empty: those of the suite or of the scenario
  RunChoice run;                     // speed, step and tolerances of every run; form, method, refine and threads are
                                     // not read
  std::vector<SharedColumn> shared = usualSharedColumns();  // each beside its serial run, where that is run
  // [s] that a shared run may take, and as much again for every 10 000 steps; nothing: as long as it needs. Four
  // threads on two cores that other programs keep busy take milliseconds a step, 500 times what they take in peace.
  std::optional<double> shared_time_limit;
};

/// A form that cannot represent the vehicle (method empty), or a method that cannot integrate the form.
struct Unsupported {
  std::string form;
  std::string method;
  std::string reason;
};

/// What a case consists of, before anything of it is run.
struct ValidationPlan {
  std::vector<RunKey> runs;  // number 0 is the reference; rk4 at the step that was chosen
  std::vector<Unsupported> unsupported;
  std::vector<std::string> notes;
};

/// Every form by every method that fits. The exact solution of the matrix form is always there as the reference, and
/// each rk4 run brings one at half the step. A chosen form that no chosen method can integrate is run by its default
/// method, with a note.
/// @throws std::invalid_argument  a form or method that does not exist
[[nodiscard]] ValidationPlan validationPlanOf(const CompiledModel& model, const ValidationChoice& choice);

/// Forms that solve the same equations share the ledger's sizes: all consistent ones ("matrix"), and each printed
/// variant.
[[nodiscard]] std::string equationsOf(const std::string& form);

/// Whether run j > i is compared with run i. A run at half the step is there to show the order, which only the exact
/// solution of its equations can.
[[nodiscard]] bool areCompared(const std::vector<RunKey>& runs, std::size_t i, std::size_t j);

/// Whether two of the runs are compared of which something is expected.
[[nodiscard]] bool judgesAnything(const ValidationPlan& plan);

/// Why a case cannot be validated, with the remedy; empty if it can: the histories of all runs together are more than it
/// may hold (2 GiB), or the motion grows beyond any comparison (1e12-fold).
/// @param speed  [m/s]
[[nodiscard]] std::string caseRefusal(const ValidationPlan& plan, const CompiledModel& model, const Scenario& scenario,
                                      double speed);

}  // namespace vehicle
