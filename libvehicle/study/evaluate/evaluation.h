#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/diagnostics/warning_set.h"

namespace vehicle {

// The seam between who evaluates designs and who shares them out: a pure function from consecutive design numbers to
// rows of numbers. A row depends on its design alone, never on batch, thread or rank, so a table has the same bits
// however the work was cut.

/// Consecutive design numbers first .. end-1.
struct DesignSpan {
  std::int64_t first = 0;
  std::int64_t end = 0;
  [[nodiscard]] std::int64_t size() const { return end - first; }
  bool operator==(const DesignSpan&) const = default;
};

/// Why a design has no results.
struct DesignFailure {
  std::int64_t design = 0;
  std::string message;
  bool operator==(const DesignFailure&) const = default;
};

/// Why some values of a design are missing; the others stand.
struct DesignGap {
  std::int64_t design = 0;
  std::string message;  // gapMessage()
  bool operator==(const DesignGap&) const = default;
};

/// Where the results of a design left what its model can say.
struct DesignWarnings {
  std::int64_t design = 0;
  WarningSet warnings;
  bool operator==(const DesignWarnings&) const = default;
};

/// A design of a batch.
struct EvaluatedDesign {
  std::int64_t design = 0;
  std::span<double> row;     // (columns); NaN where there is no value
  bool failed = false;       // nothing of the row but its parameters counts
  std::string_view message;  // why it failed, or why values are missing; else empty
  WarningSet warnings = {};
};

/// Results of a range. Storage is kept from batch to batch.
struct Batch {
  DesignSpan range;
  std::vector<double> values;           // (designs x columns), row-major; NaN where there is none
  std::vector<DesignFailure> failures;  // ascending
  std::vector<DesignGap> gaps;          // ascending, of designs that did not fail
  std::vector<DesignWarnings> warnings; // the same

  /// Empties it for a new range: all values NaN, no failures, gaps or warnings.
  void reset(DesignSpan designs, std::size_t columns);
  /// Row of a design of the range.
  [[nodiscard]] std::span<double> row(std::int64_t design, std::size_t columns) {
    return {values.data() + static_cast<std::size_t>(design - range.first) * columns, columns};
  }
  /// Calls visit(const EvaluatedDesign&) for each design in order.
  template <class Visit>
  void forEach(std::size_t columns, Visit visit) {
    auto failure = failures.begin();
    auto gap = gaps.begin();
    auto warned = warnings.begin();
    for (std::int64_t design = range.first; design < range.end; ++design) {
      EvaluatedDesign each{design, row(design, columns), false, {}, {}};
      if (failure != failures.end() && failure->design == design) {
        each.failed = true;
        each.message = (failure++)->message;
      } else if (gap != gaps.end() && gap->design == design) {
        each.message = (gap++)->message;
      }
      if (warned != warnings.end() && warned->design == design) each.warnings = (warned++)->warnings;
      visit(each);
    }
  }
};

/// What is evaluated in one call.
struct Task {
  DesignSpan range;
  /// (designs x given), row-major: numbers that do not follow from a design's own number, as an optimiser chooses
  /// them; empty where a plan tells everything.
  std::span<const double> given;
};

/// Evaluates designs on one thread: owns its workspace, is never called concurrently.
class Worker {
 public:
  virtual ~Worker() = default;

  /// Fills batch.values, failures, gaps and warnings for the task's designs; the batch comes reset. What is wrong with
  /// one design becomes its failure; a value that it cannot have stays NaN and its reason becomes a gap.
  /// @throws whatever ends the whole study (memory, a mistake of ours)
  virtual void evaluate(const Task& task, Batch& batch) = 0;
};

/// What is to be known of every design. Const: one serves all threads; each asks for its worker on itself.
class Evaluator {
 public:
  virtual ~Evaluator() = default;
  [[nodiscard]] virtual std::size_t columns() const = 0;         // numbers in a row
  [[nodiscard]] virtual std::size_t given() const { return 0; }  // numbers of a design that a task has to tell
  [[nodiscard]] virtual std::int64_t batchSize() const = 0;      // designs that are best evaluated in one call, >= 1
  [[nodiscard]] virtual std::unique_ptr<Worker> worker() const = 0;
};

}  // namespace vehicle
