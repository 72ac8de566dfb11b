#pragma once

#include <string>

#include <Eigen/Core>

#include "libvehicle/validation/case_size.h"

namespace vehicle {

// The tolerance ledger: how far two runs may differ, column by column, and why. No size is a fixed guess; each
// follows from the vehicle, the track, the speed and the method's own settings. docs/theory/validation.md derives it.

/// Why two runs differ.
enum class Source {
  kRounding,
  kIntegration,
  kGeometry
};
[[nodiscard]] const char* nameOf(Source source);

/// One run of a case: everything that decides its result. Two runs with equal keys are one.
struct RunKey {
  std::string form = {};
  std::string method = {};
  int refine = 1;            // rk4: 1 at the step, 2 at half the step
  double step = 1e-3;        // [s] rk4
  double relative = 0.0;     // dopri5
  double absolute = 0.0;     // dopri5
  double accuracy = 0.0;     // simbody_rkm
  std::string scheme = {};   // of a run shared among threads; empty: serial
  int threads = 1;           // that share it
  std::string map = "auto";  // who of them computes which equation
  bool operator==(const RunKey&) const = default;
  /// For people: "flat rk4", "mbs simbody_rkm", "matrix rk4 h/2", "flat rk4 stages x4 map paper". Steps and tolerances
  /// are left out, so that two keys may have the same text.
  [[nodiscard]] std::string text() const;
};

/// Whether the run makes fixed steps, so that a second run with half the step tells its error.
[[nodiscard]] bool hasFixedSteps(const RunKey& run);

/// Whether two runs are the same computation, shared among threads in different ways: their bits must be equal.
[[nodiscard]] bool haveEqualBits(const RunKey& a, const RunKey& b);

/// What one run may be away from the true solution of its own equations, and from the linear equations;
/// (outputs), in each column's unit.
struct RunSize {
  Eigen::VectorXd rounding;        // of its own arithmetic
  Eigen::VectorXd input_rounding;  // of the rail: common to runs of one method
  Eigen::VectorXd integration;
  Eigen::VectorXd geometry;  // zero unless the form has the true geometry
};

/// @param steps            that the run took
/// @param step_difference  (outputs) rk4: max |y(h) - y(h/2)| of this form, from which Richardson's extrapolation
///                         estimates the error; others: not read
[[nodiscard]] RunSize sizeOfRun(const CaseSize& the_case, const RunKey& run, long steps,
                                const Eigen::VectorXd& step_difference);

/// What to expect of a pair.
struct Expectation {
  Eigen::VectorXd size;               // (outputs) largest difference that the sources explain, in each column's unit
  Eigen::VectorXd rounding;           // (outputs) the part of it that is rounding
  Source source = Source::kRounding;  // the largest part, where the expectation is largest against the column's peak
  std::string why;                    // in words
};

/// The sum of both sides' sizes, except what both sides share: the same rk4 steps make the same integration error,
/// the same method rounds the rail alike, and two forms of true geometry leave nothing out. Zero where the bits must be
/// equal.
[[nodiscard]] Expectation expectationOf(const CaseSize& the_case, const RunKey& a, const RunSize& a_size,
                                        const RunKey& b, const RunSize& b_size);

}  // namespace vehicle
