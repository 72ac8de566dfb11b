#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <span>
#include <vector>

#include "libvehicle/system/input.h"

namespace vehicle {

/// A piece of a run without breakpoint and without a sample inside.
struct Interval {
  int segment = 0;     // of the input: the one whose formula holds on [begin, end]
  double begin = 0.0;  // [s]
  double end = 0.0;    // [s]
  int sample = -1;     // number of the sample at `end`, or -1
  int next = 0;        // the segment that holds right after `end`: what an observer of the sample there gets
  int output = -1;     // number of the output sample at `end`, or -1
  int regular = -1;    // number of the point of the regular grid at `end`, or -1 (Sampling)
  double whole = 0.0;  // [s] the length that is meant where it is a whole step of the grid; 0: another length
  std::size_t alike = 0;     // intervals from this one on that are such whole steps, in this segment; 0: it is none
  double segment_end = 0.0;  // [s] up to there the segment's formula holds
};

/// Most output samples a run may have: beyond, the grid itself is no longer exact to a billionth of a step.
inline constexpr int kMostSamples = 10'000'000;
/// Most samples of a run that is measured; one that would need more is measured more coarsely.
inline constexpr double kMostRunSamples = 2e7;
/// Of an output step: closer than this, two instants are one.
inline constexpr double kSameInstant = 1e-9;

/// The instants begin + i step / cut. Where the step is a short decimal number (5 ms) each is the double nearest to that
/// decimal, so that files show 0.035 and not 0.035000000000000003.
class SampleGrid {
 public:
  /// @param step  [s] > 0
  SampleGrid(double begin, double step);
  /// @param cut  >= 1
  [[nodiscard]] double time(std::int64_t i, int cut = 1) const;

 private:
  double begin_;
  double step_;
  double numerator_ = 0.0;  // step = numerator / denominator, whole numbers; 0: it is no short decimal
  double denominator_ = 1.0;
};

/// Number of the output sample begin + i output_step that t is, within a billionth of a step; or -1.
[[nodiscard]] int sampleAt(double begin, double output_step, double t);

/// Where a run is looked at.
struct Sampling {
  double output_step = 5e-3;  // [s] > 0: between samples that are kept
  /// [rad/s] of the fastest motion of the system: samples lie so close that it has kPointsPerTurn of them a period, and
  /// as many a period of the fastest harmonic that the rail has at the time.
  double fastest = 0.0;
  int steps = 0;            // fixed steps that an output step is cut into: samples end steps; 0: any
  double count_from = 0.0;  // [s] an output sample: the motion is measured from there on, and an interval ends there
};
inline constexpr double kPointsPerTurn = 20.0;

/// Samples of a run and breakpoints of its input, merged once, in indices. Intervals join bit for bit, each is longer
/// than a billionth of an output step, and one ends on each breakpoint; a breakpoint that is a sample (within a
/// billionth of a step) ends one interval. The first sample stands at the begin, the last at the end of the input.
///
/// Memory goes with the segments of the input, not with the length of the run.
class Schedule {
 public:
  /// Looked at every output step alone.
  /// @throws std::invalid_argument unless output_step > 0 and the input lasts at least one output step and at
  ///         most kMostSamples of them
  Schedule(const Input& input, double output_step);
  /// Looked at closely enough to measure peaks and means (Sampling): at output samples, at points between them and on
  /// both sides of every breakpoint.
  Schedule(const Input& input, const Sampling& sampling);

  /// Intervals of one segment: those between points are equally long, the first and the last may be shorter.
  struct Part {
    int segment = 0;
    int next = 0;              // the segment after it
    double begin = 0.0;        // [s]
    double end = 0.0;          // [s]
    int cut = 1;               // points of an output step
    int finer = 1;             // points between two of the regular grid
    std::int64_t first = 0;    // number of the first point of the grid behind `begin`
    std::size_t count = 1;     // intervals
    bool first_whole = false;  // whether `begin` is a point of the grid
    bool last_whole = false;   // whether `end` is one
    bool shown = true;         // whether `end` is a sample
    bool counts = true;        // whether the motion is measured here
    double segment_end = 0.0;  // [s] of this part, or of a later one of the same segment
    std::size_t first_interval = 0;
    int first_sample = 0;  // number of the sample at the end of its first interval
    int last_output = -1;  // at `end`
    int last_regular = -1;
  };

  class Iterator;
  /// The intervals of a run, made one by one as they are asked for. Cost of [] grows with the logarithm of the segments.
  class Intervals {
   public:
    explicit Intervals(const Schedule& schedule) : schedule_(&schedule) {}
    [[nodiscard]] std::size_t size() const { return schedule_->interval_count_; }
    [[nodiscard]] bool empty() const { return size() == 0; }
    [[nodiscard]] Interval operator[](std::size_t index) const { return schedule_->intervalAt(index); }
    [[nodiscard]] Interval front() const { return (*this)[0]; }
    [[nodiscard]] Interval back() const { return (*this)[size() - 1]; }
    [[nodiscard]] Iterator begin() const;
    [[nodiscard]] Iterator end() const;

   private:
    const Schedule* schedule_;
  };
  [[nodiscard]] Intervals intervals() const { return Intervals(*this); }
  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }

  [[nodiscard]] int samples() const { return samples_; }  // the one at the start included
  [[nodiscard]] int outputs() const { return outputs_; }  // those that are kept
  [[nodiscard]] double time(int sample) const;
  [[nodiscard]] double outputStep() const { return sampling_.output_step; }
  /// Regular points of an output step: a grid that is the same in all segments.
  [[nodiscard]] int cut() const { return cut_; }
  /// Whether the samples are as close as the sampling asks for; else kMostRunSamples or the fixed steps forbade it.
  [[nodiscard]] bool isResolved() const { return resolved_; }

 private:
  friend class Iterator;
  void chooseCut(const Input& input);
  [[nodiscard]] int cutOf(double angular_frequency) const;
  [[nodiscard]] int fitting(int wanted, int multiple_of) const;
  void addParts(const Input& input);
  void addPart(const Part& part);
  [[nodiscard]] double pointTime(const Part& part, std::int64_t point) const { return grid_.time(point, part.cut); }
  [[nodiscard]] const Part& partOf(std::size_t interval) const;
  [[nodiscard]] Interval intervalOf(const Part& part, std::size_t index) const;
  [[nodiscard]] Interval intervalAt(std::size_t index) const { return intervalOf(partOf(index), index); }

  double begin_;
  double end_;
  Sampling sampling_;
  SampleGrid grid_;
  bool measures_;
  bool resolved_ = true;
  int cut_ = 1;
  int samples_ = 1;
  int outputs_ = 1;
  std::size_t interval_count_ = 0;
  std::vector<Part> parts_;
};

/// Goes through the intervals in order.
class Schedule::Iterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = Interval;
  using difference_type = std::ptrdiff_t;
  using pointer = const Interval*;
  using reference = Interval;

  Iterator(const Schedule& schedule, std::size_t index)
      : schedule_(&schedule),
        index_(index),
        part_(index < schedule.interval_count_ ? &schedule.partOf(index) : nullptr) {}
  [[nodiscard]] Interval operator*() const { return schedule_->intervalOf(*part_, index_); }
  [[nodiscard]] const Part& part() const { return *part_; }
  [[nodiscard]] std::size_t index() const { return index_; }
  Iterator& operator++() {
    if (++index_ == part_->first_interval + part_->count) ++part_;
    return *this;
  }
  [[nodiscard]] bool operator==(const Iterator& other) const { return index_ == other.index_; }

 private:
  const Schedule* schedule_;
  std::size_t index_;
  const Part* part_;
};

inline Schedule::Iterator Schedule::Intervals::begin() const { return {*schedule_, 0}; }
inline Schedule::Iterator Schedule::Intervals::end() const { return {*schedule_, size()}; }

/// Called at every sample in order, sample 0 included. At a breakpoint `segment` is the one that begins there
/// (right-hand limit). Returning false ends the run after this sample.
using Observer = std::function<bool(int sample, int segment, double t, std::span<const double> x)>;

/// What a run cost.
struct Statistics {
  long steps = 0;
  long evaluations = 0;  // of f(x, u); for `exact`: matrix exponentials
  long rejected = 0;     // steps repeated with a smaller size
  bool stopped = false;  // an observer ended it early
};

}  // namespace vehicle
