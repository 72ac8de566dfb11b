#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/model/bound_study.h"
#include "libvehicle/study/plan/design_list.h"
#include "libvehicle/study/plan/latin_hypercube.h"
#include "libvehicle/study/plan/sobol_sequence.h"

namespace vehicle {

/// Which named design a number stands for and which point of the plan.
struct DesignIdentity {
  std::size_t named = 0;               // in BoundStudy::designs; 0 is "base"
  std::optional<std::uint64_t> point;  // nothing: the named design as it is
};

/// Points of a block of a Saltelli plan.
[[nodiscard]] std::size_t saltelliMembers(std::size_t factors, SecondOrder order);

/// Every design of a study by its number: the parameter values follow from the study and the number alone, and no list
/// of designs is kept (but for a CSV list), so any thread or rank may begin anywhere.
///
/// Numbers: 0 is "base", the vehicle as its file says it; 1 .. K are the named designs as they are. If anything is
/// varied, the plan's N points follow for "base", then for each named design:  1 + K + named * N + point.
/// In a grid the last <vary> runs fastest. A Saltelli plan has its points in blocks A, B, AB_1 .. AB_d, with second
/// order followed by BA_1 .. BA_d (sensitivity.h). A search has no points: it makes its own.
class DesignPlan {
 public:
  /// @param study   in order by check()
  /// @param bound   the study bound to its vehicle and scenarios
  /// @param list    of a plan kind="list"
  /// Problems: more than 10^9 designs, too many factors, a listed parameter that a named design sets too.
  [[nodiscard]] static Outcome<DesignPlan> of(const Study& study, BoundStudy bound, DesignList list = {});

  [[nodiscard]] const BoundStudy& study() const { return study_; }
  /// Number of designs, base and named ones included.
  [[nodiscard]] std::uint64_t size() const;
  /// Number of points of the plan, 0 if nothing is varied.
  [[nodiscard]] std::uint64_t points() const { return points_; }

  [[nodiscard]] DesignIdentity identityOf(std::uint64_t design) const;
  /// "base", "soft"; of the plan "#12", "soft #12", counted from 0.
  [[nodiscard]] std::string nameOf(std::uint64_t design) const;

  /// Values of all parameters of the study [SI].
  /// @param design  < size()
  /// @param values  shape (parameters)
  void valuesOf(std::uint64_t design, std::span<double> values) const;

  /// The same for a place of the unit cube instead of a point of the plan: what a search asks for.
  /// @param unit    shape (factors), 0 <= u <= 1
  void valuesAt(std::size_t named, std::span<const double> unit, std::span<double> values) const;

 private:
  DesignPlan() = default;
  void takeGrid();
  bool takeSequence(const Plan& plan, const Place& place, ProblemList& problems);
  void setNamed(std::size_t named, std::span<double> values) const;
  void setFactor(std::size_t factor, double value, std::span<double> values) const;
  void setPoint(std::uint64_t point, std::span<double> values) const;

  struct Grid {};
  struct Saltelli {
    SobolSequence sequence;     // 2 x factors dimensions
    std::uint64_t members = 0;  // points of a block
  };
  BoundStudy study_;
  std::uint64_t points_ = 0;
  std::variant<Grid, LatinHypercube, SobolSequence, Saltelli, DesignList> plan_;
};

}  // namespace vehicle
