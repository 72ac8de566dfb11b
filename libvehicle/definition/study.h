#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/definition/metric.h"
#include "libvehicle/definition/origin.h"
#include "libvehicle/definition/suite.h"

namespace vehicle {

// A comparison of many designs of one vehicle, as the user said it. Values stay text: which dimension they
// must have only the vehicle can tell; bound_study.h reads them.

/// What a <vary>'s values are.
enum class Variation {
  kAbsolute,  // the parameter's own, "20 kN*s/m"
  kRelative,  // multiples of what the file gives, "80 %" or "0.8"
};

enum class Spacing {
  kLinear,
  kLogarithmic,
};

/// A parameter, or several tied ones, that takes a range or a list of values.
struct Vary {
  std::string parameter;  // "front_bogie.mass, rear_bogie.mass": every one gets the value
  Variation kind = Variation::kAbsolute;
  std::string from;  // range, as written; with to
  std::string to;
  std::optional<int> count;  // steps of the range, both ends included; without: any value between (no grid)
  Spacing spacing = Spacing::kLinear;
  std::string values;  // list, "80 km/h, 120 km/h"; instead of a range
  Origin origin;
  bool operator==(const Vary&) const = default;
};

enum class PlanKind {
  kGrid,            // all values of all <vary> crossed
  kLatinHypercube,  // `size` designs, every parameter stratified
  kSobol,           // `size` designs of a Sobol sequence
  kSaltelli,        // size * (parameters + 2) designs for sensitivity indices, see SecondOrder
  kList,            // designs of a CSV file
};

/// Seed of a plan that draws and names none.
inline constexpr int kPlanSeed = 1;

/// Whether a kSaltelli tells the indices of pairs of parameters too.
enum class SecondOrder {
  kNo,
  kYes,  // size * (2 parameters + 2) designs
};

struct Plan {
  PlanKind kind = PlanKind::kGrid;
  std::optional<int> size;  // >= 1
  std::optional<int> seed;  // of a plan that draws; kPlanSeed where it is not given
  SecondOrder second_order = SecondOrder::kNo;
  std::string file;  // of a kList, counted from the folder of the study
  Origin origin;
  bool operator==(const Plan&) const = default;
};

enum class SearchMethod {
  kNsga2,
  kNspso,
};

/// Multi-objective optimisation within the ranges of the <vary>, instead of a plan.
struct Search {
  SearchMethod method = SearchMethod::kNsga2;
  int population = 100;
  int generations = 100;
  int seed = 1;
  Origin origin;
  bool operator==(const Search&) const = default;
};

struct StudySet {
  std::string parameter;  // one or several tied ones
  std::string value;
  Origin origin;
  bool operator==(const StudySet&) const = default;
};

/// A design with a name, to be compared with the vehicle as its file says it (the design "base").
struct StudyDesign {
  std::string name;
  std::string title;
  std::vector<StudySet> sets;
  Origin origin;
  bool operator==(const StudyDesign&) const = default;
};

struct StudyMetric {
  std::string name;  // metric.h
  Origin origin;
  bool operator==(const StudyMetric&) const = default;
};

enum class Goal {
  kMinimise,
  kMaximise,
};

/// How the values of several speeds and scenarios become one.
enum class Over {
  kWorst,
  kMean,
};

struct Objective {
  std::string metric;
  Goal goal = Goal::kMinimise;
  Over over = Over::kWorst;
  Origin origin;
  bool operator==(const Objective&) const = default;
};

/// A bound that every speed and scenario has to keep.
struct Limit {
  std::string metric;
  std::string below;  // at most this, as written; one of the two or both
  std::string above;  // at least this
  Origin origin;
  bool operator==(const Limit&) const = default;
};

/// Where the numbers come from.
enum class Evaluation {
  kRun,          // a run over the scenario
  kSteadyState,  // the periodic motion under harmonics, in closed form
};

struct Study {
  std::string name;
  std::string title;
  std::string source;
  double settle = 0.0;  // [s] >= 0: start of each run that the metrics leave out
  Evaluation evaluation = Evaluation::kRun;
  FileReference vehicle;
  std::vector<FileReference> scenarios;
  std::vector<Vary> varies;
  std::optional<Plan> plan;  // without plan and search: the grid
  std::vector<StudyDesign> designs;
  std::vector<StudyMetric> metrics;
  std::vector<Objective> objectives;
  std::vector<Limit> limits;
  std::optional<Search> search;
  Origin origin;
  bool operator==(const Study&) const = default;
};

/// "a, b" -> {"a", "b"}, spaces around the items dropped; an empty item stays, so that it can be told.
[[nodiscard]] std::vector<std::string> listedIn(std::string_view text);

/// Whether this <vary> names the speeds at which every design runs (one row, speeds in columns) instead of being
/// a property of the design: parameter="speed" alone, as a list or as a range with count.
[[nodiscard]] bool givesSpeeds(const Vary& vary);

/// The design that is the vehicle as its file says it; no other may be called so.
inline constexpr std::string_view kBaseDesign = "base";

/// Contradictions that show without the vehicle: what is missing, given twice, or does not go together.
[[nodiscard]] ProblemList check(const Study& study);

/// The study without the parts that have problems: the rest can still be held against the vehicle (bindStudy()), so
/// that all problems of a file come in one pass.
[[nodiscard]] Study soundPartOf(const Study& study, const ProblemList& problems);

}  // namespace vehicle
