#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/model/compiled_model.h"
#include "libvehicle/partition/choose.h"
#include "libvehicle/result/history_sink.h"
#include "libvehicle/result/time_history.h"
#include "libvehicle/simulate/forms.h"
#include "libvehicle/simulate/methods.h"
#include "libvehicle/simulate/recorder.h"
#include "libvehicle/simulate/shared_run.h"
#include "libvehicle/system/schedule.h"
#include "libvehicle/threads/team.h"

namespace vehicle {

/// What to run and how.
struct RunChoice {
  std::string form;             // empty: flat where it fits, else matrix
  std::string method;           // empty: exact where it fits and few states ask for it, else dopri5
  std::optional<double> speed;  // [m/s]; empty: the scenario's
  std::optional<double> step;   // [s] rk4: largest fixed step; empty: as the fastest motion asks (run_plan.h)
  int refine = 1;               // rk4: cuts every fixed step once more (convergence orders)
  double relative = 1e-10;      // dopri5
  double absolute = 1e-12;      // dopri5, in the state's unit
  double accuracy = 1e-10;      // simbody_rkm

  Keep keep = Keep::kOutputs;  // what becomes the history in memory
  bool measures = true;        // peaks, means and warnings, from samples close enough; false: output samples alone
  double settle = 0.0;         // [s] start of the run that summaries leave out, up to the next output sample

  // Threads change the speed of a run and no bit of its result.
  Sharing sharing;  // 0 threads: as many as a short calibration finds to be fastest, 1 where none is
  TeamPolicy team;  // placement, priority, waiting, tracer
};

struct RunResult {
  TimeHistory history;
  std::vector<ColumnSummary> summaries;  // of its columns after time; empty where nothing was measured
  Warnings warnings;                     // where vehicle, step or result are outside what the model can say
  std::vector<std::string> notes;        // what was chosen for the caller
  Statistics statistics;
  std::string form;
  std::string method;
  double speed = 0.0;         // [m/s]
  double step = 0.0;          // [s] largest step of a fixed-step method; 0: others
  double reached = 0.0;       // [s] the end of the run, or where it was ended
  long outputs = 0;           // samples of the history, kept or not
  double wall_seconds = 0.0;  // of the integration, outputs included, building the form excluded
  std::string scheme = "serial";
  int threads = 1;
  TeamReport team;            // one entry a thread; none where the caller's own thread did the run
  std::vector<ThreadWork> work;  // of each of them
  Decision decision;          // what the calibration found; its reason is empty where the choice left nothing open
};

/// One run: compiled model and names in, time history out.
/// @param model  under the scenario's gravity
/// @throws InvalidInput           the scenario is wrong, alone or beside the vehicle, or the form does not fit
/// @throws std::invalid_argument  form, method, speed, step, tolerance, threads, scheme or map is wrong or does
///                                not fit the others; the message says which
/// @throws RunFailed              NaN, or an integrator gave up; names column and time
/// @param sink  takes the output samples as they are made, whatever choice.keep says of the result's own history; none:
///              nobody does. What it throws ends the run
[[nodiscard]] RunResult simulate(const CompiledModel& model, const Scenario& scenario, const RunChoice& choice = {},
                                 const Progress& progress = {}, HistorySink* sink = nullptr);

/// The same of a definition, compiled for this run.
/// @throws InvalidInput  also if the vehicle contradicts itself or its springs cannot carry the weight; what is wrong
///                       with vehicle and scenario is reported together
[[nodiscard]] RunResult simulate(const Vehicle& vehicle, const Scenario& scenario, const RunChoice& choice = {},
                                 const Progress& progress = {});

/// Refuses a scenario that a model cannot be run over.
/// @throws InvalidInput           the scenario is wrong, or names parts that the vehicle does not have
/// @throws std::invalid_argument  the model was compiled under another gravity
void requireRunnable(const CompiledModel& model, const Scenario& scenario);

}  // namespace vehicle
