#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libvehicle/result/time_history.h"
#include "libvehicle/validation/ledger.h"
#include "libvehicle/validation/norms.h"

namespace vehicle {

/// Quantities that are told together.
enum class QuantityGroup {
  kDisplacements,
  kVelocities,
  kAccelerations,
  kForces
};
[[nodiscard]] const char* nameOf(QuantityGroup group);
/// By the unit: m and rad, m/s and rad/s, m/s^2 and rad/s^2, N.
[[nodiscard]] QuantityGroup groupOf(const Channel& column);

enum class Verdict {
  kInside,     // no column differs by more than the ledger explains
  kOutside,    // one does
  kByDesign,   // a printed variant: other equations, nothing is expected of it
  kNotJudged,  // one of the runs has no result; such a pair has no columns and groups
};
[[nodiscard]] const char* nameOf(Verdict verdict);

struct ColumnAgreement {
  Channel column;
  Norms norms;
  std::optional<double> expected;  // largest difference the ledger explains, in the column's unit
  bool inside = true;
};

/// Over the columns of a group, each norm by its largest value; columns that are nothing but rounding count as 0.
struct GroupAgreement {
  QuantityGroup group = QuantityGroup::kDisplacements;
  double relative = 0.0;   // [-] max difference / peak of the reference's column
  double nrmse = 0.0;      // [-]
  double magnitude = 0.0;  // [-] the one of largest size, with its sign
  double phase = 0.0;      // [-]
  double combined = 0.0;   // [-]
  std::string column;      // where `relative` is largest
};

struct PairAgreement {
  std::size_t first = 0;   // number of the run that serves as reference here
  std::size_t second = 0;  // number of the other run
  Verdict verdict = Verdict::kInside;
  std::optional<Source> source;  // what the expectation mostly consists of; none where nothing is expected
  std::string why;               // the expectation in words
  std::vector<ColumnAgreement> columns;
  std::vector<GroupAgreement> groups;
  std::size_t worst = 0;           // number in `columns`: nearest to its limit, or farthest outside
  double relative = 0.0;           // [-] there: difference / peak
  std::optional<double> expected;  // [-] there: expected difference / peak
};

/// Compares two histories of the same columns and samples, column by column. The caller fills in first and second.
/// @param expectation  none: the two differ by design
/// @throws std::invalid_argument if columns or samples differ
[[nodiscard]] PairAgreement compareHistories(const TimeHistory& reference, const TimeHistory& other,
                                             const std::optional<Expectation>& expectation);

/// max |a - b| of every column after time, (columns - 1).
[[nodiscard]] Eigen::VectorXd largestDifference(const TimeHistory& a, const TimeHistory& b);

}  // namespace vehicle
