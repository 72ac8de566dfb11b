#include "libvehicle/validation/agreement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace vehicle {
namespace {

void requireSameShape(const TimeHistory& a, const TimeHistory& b) {
  if (a.samples() != b.samples() || a.samples() == 0) {
    throw std::invalid_argument(
        fmt::format("histories of {} and {} samples cannot be compared", a.samples(), b.samples()));
  }
  if (a.columns() != b.columns()) throw std::invalid_argument("histories of different columns cannot be compared");
}

/// How much of its allowance a column has used; infinite where nothing is allowed or the difference is no number.
double usedShare(const ColumnAgreement& column) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (std::isnan(column.norms.max_difference)) return kInfinite;
  if (!column.expected) return column.norms.relative;
  if (column.norms.max_difference == 0.0) return 0.0;
  return *column.expected > 0.0 ? column.norms.max_difference / *column.expected : kInfinite;
}

std::vector<GroupAgreement> groupsOf(const std::vector<ColumnAgreement>& columns) {
  std::vector<GroupAgreement> groups;
  for (const ColumnAgreement& column : columns) {
    const QuantityGroup group = groupOf(column.column);
    auto found = std::find_if(groups.begin(), groups.end(), [&](const GroupAgreement& g) { return g.group == group; });
    if (found == groups.end()) {
      groups.push_back({});
      found = groups.end() - 1;
      found->group = group;
      found->column = column.column.name;
    }
    const Norms& norms = column.norms;
    // Written so that a NaN wins.
    if (!(norms.relative <= found->relative)) {
      found->relative = norms.relative;
      found->column = column.column.name;
    }
    if (!(norms.nrmse <= found->nrmse)) found->nrmse = norms.nrmse;
    if (!(std::abs(norms.magnitude) <= std::abs(found->magnitude))) found->magnitude = norms.magnitude;
    if (!(norms.phase <= found->phase)) found->phase = norms.phase;
    if (!(norms.combined <= found->combined)) found->combined = norms.combined;
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const GroupAgreement& a, const GroupAgreement& b) { return a.group < b.group; });
  return groups;
}

}  // namespace

const char* nameOf(QuantityGroup group) {
  switch (group) {
    case QuantityGroup::kDisplacements:
      return "displacements";
    case QuantityGroup::kVelocities:
      return "velocities";
    case QuantityGroup::kAccelerations:
      return "accelerations";
    case QuantityGroup::kForces:
      return "forces";
  }
  return "";
}

QuantityGroup groupOf(const Channel& column) {
  if (column.unit.ends_with("/s^2")) return QuantityGroup::kAccelerations;
  if (column.unit.ends_with("/s")) return QuantityGroup::kVelocities;
  if (column.unit == "N") return QuantityGroup::kForces;
  return QuantityGroup::kDisplacements;
}

const char* nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kInside:
      return "inside";
    case Verdict::kOutside:
      return "OUTSIDE";
    case Verdict::kByDesign:
      return "differs by design";
    case Verdict::kNotJudged:
      return "not judged";
  }
  return "";
}

PairAgreement compareHistories(const TimeHistory& reference, const TimeHistory& other,
                               const std::optional<Expectation>& expectation) {
  requireSameShape(reference, other);
  PairAgreement pair;
  pair.verdict = expectation ? Verdict::kInside : Verdict::kByDesign;
  if (expectation) {
    pair.source = expectation->source;
    pair.why = expectation->why;
  } else {
    pair.why = "other equations: a printed variant";
  }
  double worst_share = -1.0;
  for (std::size_t i = 1; i < reference.columns().size(); ++i) {
    const Eigen::Index row = static_cast<Eigen::Index>(i - 1);
    ColumnAgreement column;
    column.column = reference.columns()[i];
    column.norms = compareColumns(reference.column(i), other.column(i), expectation ? expectation->rounding(row) : 0.0);
    if (expectation) {
      column.expected = expectation->size(row);
      column.inside = column.norms.max_difference <= *column.expected;  // false for NaN
      if (!column.inside) pair.verdict = Verdict::kOutside;
    }
    // A column of nothing but rounding says little; it is named only if it is the one that breaks its limit.
    const bool speaks = !column.inside || column.norms.relative > 0.0;
    if (const double share = speaks ? usedShare(column) : 0.0; share > worst_share) {
      worst_share = share;
      pair.worst = pair.columns.size();
    }
    pair.columns.push_back(std::move(column));
  }
  if (!pair.columns.empty()) {
    const ColumnAgreement& worst = pair.columns[pair.worst];
    pair.relative = worst.norms.relative;
    if (worst.expected && worst.norms.peak > 0.0) pair.expected = *worst.expected / worst.norms.peak;
  }
  pair.groups = groupsOf(pair.columns);
  return pair;
}

Eigen::VectorXd largestDifference(const TimeHistory& a, const TimeHistory& b) {
  requireSameShape(a, b);
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(a.columns().size()) - 1);
  for (std::size_t i = 0; i < a.samples(); ++i) {
    for (Eigen::Index j = 0; j < largest.size(); ++j) {
      const std::size_t column = static_cast<std::size_t>(j) + 1;
      largest(j) = std::max(largest(j), std::abs(a.at(i, column) - b.at(i, column)));
    }
  }
  return largest;
}

}  // namespace vehicle
