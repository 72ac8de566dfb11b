#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "libvehicle/ensemble/ensemble.h"
#include "libvehicle/integrate/fixed_steps.h"
#include "libvehicle/integrate/rk4.h"
#include "libvehicle/result/column_summary.h"
#include "libvehicle/system/sample_weights.h"
#include "tests/support/tolerance.h"

// The witness: one design at a time by FixedSteps and the columns of flat/flat_form.cc written anew.
namespace vehicle::test {

/// All columns of a design at one instant.
/// @param u  (12) heights, rates, accelerations of the rail
inline std::vector<double> columnsAt(const EnsembleDesign& design, const double* x, const double* u) {
  const FlatParameters& v = design.vehicle;
  std::array<double, 8> dx{};
  const FlatRhs rhs(v);
  rhs(x, u, dx.data());
  const double front = x[0] + v.lf * x[1] - x[2];
  const double rear = x[0] - v.lr * x[1] - x[3];
  std::vector<double> y = {x[0], x[1], x[4], x[5], dx[4], dx[5], x[2], x[6], dx[6], x[3], x[7], dx[7],
                           front, v.cs1 * front + v.bs1 * (x[4] + v.lf * x[5] - x[6]),
                           rear, v.cs2 * rear + v.bs2 * (x[4] - v.lr * x[5] - x[7])};
  std::array<double, 4> force{};
  for (std::size_t j = 0; j < 4; ++j) {
    const double d = x[j < 2 ? 2 : 3] - u[j];
    force[j] = v.cp[j] * d + v.bp[j] * (x[j < 2 ? 6 : 7] - u[4 + j]);
    y.insert(y.end(), {d, force[j]});
  }
  for (std::size_t j = 0; j < 4; ++j) {
    y.insert(y.end(), {u[j], design.wheel_load[j] - force[j] + design.wheelset_mass[j] * u[8 + j]});
  }
  for (const double arm : design.point_arm) {
    y.insert(y.end(), {x[0] + arm * x[1], x[4] + arm * x[5], dx[4] + arm * dx[5]});
  }
  return y;
}

/// What a run leaves behind.
struct ScalarRun {
  std::vector<std::vector<double>> history;  // (points of the regular grid that count)(columns)
  std::vector<ColumnSummary> summaries;      // (columns)
};

/// One design by FixedSteps over the same measured schedule, both sides of every breakpoint evaluated.
inline ScalarRun scalarRun(const EnsembleDesign& design, const Input& rail, const EnsembleRun& run) {
  ScalarRun made;
  Sampling sampling{.output_step = run.output_step, .fastest = run.fastest, .steps = run.steps};
  if (run.settle > 0.0) {
    sampling.count_from = SampleGrid(0.0, run.output_step).time(firstCounted(run.settle, run.output_step));
  }
  const Schedule schedule(rail, sampling);
  Rk4<FlatRhs, 8> stepper{FlatRhs(design.vehicle)};
  ColumnSummaries summaries(kFlatColumns);
  auto next = schedule.intervals().begin();
  std::optional<SampleWeights> weights;
  const auto columns = [&](int segment, double t, std::span<const double> x) {
    std::array<double, 12> u{};
    rail.evaluate(segment, t, u);
    return columnsAt(design, x.data(), u.data());
  };
  const auto begin = [&](int segment, double t, std::span<const double> x) {
    weights.reset();
    if (!next.part().counts) return;
    weights.emplace(schedule, next.part());
    summaries.begin(t, (*weights)[0], columns(segment, t, x));
  };
  FixedSteps(stepper, rail, run.step)
      .run(schedule, design.start, [&](int sample, int segment, double t, std::span<const double> x) {
        int regular = 0;
        if (sample == 0) {
          begin(segment, t, x);
        } else {
          const Interval interval = *next;
          const Schedule::Part& part = next.part();
          const std::size_t own = next.index() - part.first_interval + 1;
          if (weights) summaries.add(t, (*weights)[own], columns(interval.segment, t, x));
          regular = interval.regular;
          const bool ends = own == part.count;
          ++next;
          if (ends && !(next == schedule.intervals().end())) begin(segment, t, x);
        }
        if (regular >= 0 && t >= sampling.count_from) made.history.push_back(columns(segment, t, x));
        return true;
      });
  made.summaries = summaries.summaries();
  return made;
}

/// Largest |value| of a column.
inline double peakOf(const std::vector<std::vector<double>>& history, std::size_t column) {
  double peak = 0.0;
  for (const std::vector<double>& row : history) peak = std::max(peak, std::abs(row[column]));
  return peak;
}

}  // namespace vehicle::test
