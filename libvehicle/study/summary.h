#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "libvehicle/storage/study_database.h"
#include "libvehicle/study/compare/missing_values.h"
#include "libvehicle/study/compare/regression.h"
#include "libvehicle/study/compare/sensitivity.h"
#include "libvehicle/study/plan/design_plan.h"
#include "libvehicle/study/study_inputs.h"

namespace vehicle {

/// One design with what the study asks of it.
struct JudgedDesign {
  std::uint64_t id = 0;
  std::string name;                  // "base", "soft", "#12", "generation 3 #7"
  std::vector<double> parameters;    // [SI]
  std::vector<double> metrics;       // [SI], NaN where there is no value; empty: it failed
  std::vector<double> objectives;    // [SI], in their own sense; NaN where a value is missing
  std::vector<double> violations;    // [SI] (limits) by how much each is overstepped, 0 where it is kept
  /// (objectives) the column of the worst case, where several are judged by their worst
  std::vector<std::optional<std::size_t>> worst;
  std::string message;  // why it failed, or why values are missing
  WarningSet warnings;  // where its results left what the model can say
  [[nodiscard]] bool failed() const { return metrics.empty(); }
  [[nodiscard]] bool keepsLimits() const;
};

/// What the factors do to one objective, or to one metric column where there are no objectives.
struct Influence {
  std::string output;                   // "carbody.az.rms", "carbody.az.rms, worst of 14"
  std::uint64_t designs = 0;            // that have a value
  std::uint64_t left_out = 0;           // that have none, or failed
  SensitivityResult indices;            // of a Saltelli plan; else empty
  std::vector<double> correlations;     // (factors) of any plan
  std::optional<Regression::Fit> fit;   // standardised straight lines
};

/// Designs whose results left what the model can say, in one respect.
struct WarnedDesigns {
  WarningCode code{};
  std::uint64_t designs = 0;
  std::string first;  // name of the first of them
};

/// A study read at a glance: what there is to be shown of any number of designs.
struct StudySummary {
  std::uint64_t designs = 0;  // of the study
  std::uint64_t stored = 0;
  std::uint64_t failed = 0;
  std::uint64_t within_limits = 0;              // of those that did not fail
  std::uint64_t incomplete = 0;                 // that lack values, of those that did not fail
  std::vector<MissingValues> missing;           // the most frequent first
  std::uint64_t warned = 0;                     // designs that have warnings
  std::vector<WarnedDesigns> warnings;          // by code
  std::vector<JudgedDesign> compared;           // base first, then the named ones; all, where they are few
  std::vector<std::vector<JudgedDesign>> best;  // (objectives) the best first, all within the limits
  std::vector<JudgedDesign> front;              // that nothing within the limits dominates, by the first objective
  std::vector<JudgedDesign> failures;           // the first of them
  std::vector<Influence> influences;
};

/// "base", a named design's name, "soft #12" for a point of the plan, or its place in the search.
[[nodiscard]] std::string designName(const StudyInputs& inputs, const DesignPlan& plan, std::uint64_t design);

struct SummaryChoice {
  std::size_t best = 5;       // of each objective
  std::size_t all_up_to = 40; // designs that are compared one by one
  std::size_t failures = 5;
  std::size_t reasons = 5;    // for which values are missing
  std::size_t outputs = 20;   // columns whose influences are told where a study has no objectives
};

/// Reads the database twice, in memory that grows with the front and, for a Saltelli plan, with 8 bytes a design and
/// output.
[[nodiscard]] StudySummary summarise(const StudyDatabase& database, const StudyInputs& inputs, const DesignPlan& plan,
                                     const SummaryChoice& choice = {});

}  // namespace vehicle
