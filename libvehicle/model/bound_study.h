#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "libvehicle/definition/parameter.h"
#include "libvehicle/definition/study.h"
#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/units/channel.h"

namespace vehicle {

// A study whose names have been looked up in its vehicle and scenarios and whose values are numbers in SI: what
// plans count through and what runs are made from.

/// A number that the study changes.
struct StudyParameter {
  std::string address;
  Dimension dimension = Dimension::kNumber;
  std::optional<VehicleParameter> in_vehicle;
  std::vector<std::optional<ScenarioParameter>> in_scenarios;  // (scenarios); empty for a vehicle's
  double base = 0.0;                                           // [SI] what the files say
};

/// One <vary> that makes designs: a range or a list for one or several tied parameters.
struct Factor {
  std::string name;                     // as written: "front_bogie.mass, rear_bogie.mass"
  std::vector<std::size_t> parameters;  // in BoundStudy::parameters
  Variation kind = Variation::kAbsolute;
  Spacing spacing = Spacing::kLinear;
  double from = 0.0;  // [SI], or multiples of what the design says
  double to = 0.0;
  std::vector<double> levels;  // the same; empty: any value from `from` to `to`
};

/// What a design is made to do once: a scenario at a speed.
struct StudyCase {
  std::size_t scenario = 0;
  double speed = 0.0;  // [m/s]
  std::string label;   // "80 km/h", "erri-low, 80 km/h"; "" if it is the only one
};

struct NamedDesign {
  std::string name;
  std::vector<std::pair<std::size_t, double>> sets;  // parameter, value [SI]
};

struct BoundMetric {
  Metric metric;
  std::string unit;      // SI
  bool per_case = true;  // false: one value for all speeds and scenarios (modes, rest)
};

struct BoundObjective {
  std::size_t metric = 0;
  Goal goal = Goal::kMinimise;
  Over over = Over::kWorst;
};

struct BoundLimit {
  std::size_t metric = 0;
  std::optional<double> below;  // [SI]
  std::optional<double> above;
};

struct BoundStudy {
  std::vector<StudyParameter> parameters;  // all that vary, list or set names, in the order of their first naming
  std::vector<Factor> factors;
  std::vector<StudyCase> cases;      // not empty; scenarios outside, speeds inside
  std::vector<NamedDesign> designs;  // [0] is "base", which sets nothing
  std::vector<BoundMetric> metrics;
  std::vector<BoundObjective> objectives;
  std::vector<BoundLimit> limits;
};

/// The header of a CSV list of designs: addresses of parameters, and the unit of the numbers below each.
struct ListedColumns {
  std::vector<Channel> columns;
  Place place;  // of the header, where problems of the columns are reported
};

/// Looks everything up and judges it: unknown names (the nearest one is named), wrong dimensions, values the vehicle
/// cannot take, columns it does not have. Names of modes only a run can confirm.
/// @param study, vehicle, scenarios  in order by their own check(); scenarios in the study's order
/// @param listed  what a list of designs brings
[[nodiscard]] Outcome<BoundStudy> bindStudy(const Study& study, const Vehicle& vehicle,
                                            const std::vector<Scenario>& scenarios, const ListedColumns& listed = {});

/// Value of a factor at the place u, 0 <= u <= 1, of its range or list: [SI] or a multiple.
[[nodiscard]] double valueAt(const Factor& factor, double u);

/// Writes the values into copies of the study's vehicle and scenarios.
/// @param values  [SI] (parameters)
void apply(const BoundStudy& study, std::span<const double> values, Vehicle& vehicle, std::vector<Scenario>& scenarios);

/// One number of a row of the study's table.
struct MetricColumn {
  std::size_t metric = 0;
  std::optional<std::size_t> study_case;  // nothing: for all cases
  Channel channel;                        // "carbody.az.rms @ 80 km/h", "m/s^2"
};

/// Metrics in the study's order, cases inside.
[[nodiscard]] std::vector<MetricColumn> metricColumns(const BoundStudy& study);
/// Addresses and SI units of the parameters, in their order.
[[nodiscard]] std::vector<Channel> parameterColumns(const BoundStudy& study);

}  // namespace vehicle
