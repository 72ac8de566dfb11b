#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/suite.h"
#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/model/compiled_model.h"
#include "libvehicle/validation/agreement.h"
#include "libvehicle/validation/plan.h"

namespace vehicle {

/// How a run of a case ended.
enum class RunEnding {
  kNotBegun,  // the work was ended on request before it
  kFinished,
  kFailed,     // it cannot be finished
  kOutOfTime,  // nobody waited for its end
};

struct ValidationRun {
  RunKey key;
  RunEnding ending = RunEnding::kNotBegun;
  std::string reason;  // why it has no result
  Statistics statistics;
  double wall_seconds = 0.0;
  std::optional<double> order;  // rk4 at half the step: log2 of the ratio of the errors, seen against `exact`
};

/// One vehicle on one track at one speed: all runs, all pairs.
struct ValidationReport {
  std::string vehicle;
  std::string scenario;
  double speed = 0.0;               // [m/s]
  std::vector<ValidationRun> runs;  // number 0 is the reference: the exact solution of the matrix form
  std::vector<Unsupported> unsupported;
  std::vector<std::string> notes;
  Warnings warnings;                // where vehicle or motion are outside what the model can say
  std::vector<PairAgreement> pairs;  // of every two runs; those with the reference first; none of an interrupted case
  bool stopped = false;              // ended early on request

  /// All evidence is there and good: every run finished, every pair was judged, at least one is inside, none outside.
  [[nodiscard]] bool inside() const;
  /// Whether a run failed.
  [[nodiscard]] bool failed() const;
  [[nodiscard]] std::size_t count(Verdict verdict) const;
};

/// Called now and then with the share done, 0..1, and what is going on; returning false ends the work.
using ValidationProgress = std::function<bool(double share, const std::string& what)>;

/// Runs every form by every method that fits and compares all pairs by the tolerance ledger (ledger.h).
///
/// The exact solution of the matrix form is always there as the reference, and each rk4 run brings one at half the
/// step, whose error must have fallen as order 4 demands. A run shared among threads must have the bits of its serial
/// one. A run that failed, or that took longer than it may, stays in the report: its pairs are not judged.
/// @param model  under the scenario's gravity
/// @throws InvalidInput           the scenario is wrong, alone or beside the vehicle
/// @throws std::invalid_argument  a form or method that does not exist, a wrong setting, histories that together would
///                                need more memory than a case may take, or a motion that grows beyond any
///                                comparison (caseRefusal())
[[nodiscard]] ValidationReport validate(const CompiledModel& model, const Scenario& scenario,
                                        const ValidationChoice& choice = {}, const ValidationProgress& progress = {});
/// The same of a definition, compiled for this case.
/// @throws InvalidInput  also if the vehicle contradicts itself or its springs cannot carry the weight
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
