#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libvehicle/system/rail_motion.h"

namespace vehicle {

/// What the rail does under every wheelset (channel) between two breakpoints. With s = t - begin:
///
///     eta_j(t) = sum_k polynomial(j,k) s^k + sum_f [ cosine(j,f) cos(w_f s) + sine(j,f) sin(w_f s) ] + sampled terms
///
/// Frequencies are shared by all channels: a delay is another mixture of the same cosine and sine, so one
/// pair per frequency serves every wheel. Only sampled terms have no closed form; methods that need one refuse them.
struct InputSegment {
  static constexpr int kPolynomial = 4;  // constant .. cubic (a cubic Hermite hold of stored samples)

  double begin = 0.0;                     // [s]
  double end = 0.0;                       // [s] > begin
  std::vector<double> angular_frequency;  // w_f [rad/s] > 0, distinct, shape (F)
  std::vector<double> cosine;             // [m] (channels x F), row-major
  std::vector<double> sine;               // [m] (channels x F), row-major
  std::vector<double> polynomial;         // [m, m/s, m/s^2, m/s^3] (channels x 4), row-major
  std::vector<SampledTerm> sampled;       // added to what stands above, in this order

  /// [rad/s] of the fastest sampled term; 0 without one.
  [[nodiscard]] double fastestSampled() const;
};

/// @param who  asks for a closed form: "exact"   @param remedy  what to do without, "" where the caller says it
/// @throws std::invalid_argument if the segment has sampled terms
void requireClosedForm(const char* who, const char* remedy, const InputSegment& segment);

/// What all channels of a sweep share: the clock and the sine and cosine of every frequency at its samples. Small even
/// for a long train, whose rows of 2 w values a sample would not fit in a cache.
struct PhasorTable {
  int segment = 0;
  int count = 0;
  std::vector<double> time;    // [s] t - begin, shape (count)
  std::vector<double> instant;  // [s] t, shape (count)
  std::vector<double> phasor;  // cos(w_f s), sin(w_f s), shape (count x 2 F), row-major
};

/// The input u(t) of a system over a whole run, cut at its breakpoints.
///
/// u = (eta_1..eta_w, eta_1'..eta_w') [m, m/s]; where accelerations are asked for, eta_1''..eta_w'' [m/s^2]
/// follow. Inside a segment eta is analytic, but for sampled terms. At a breakpoint eta is continuous and eta' or eta'' may jump: the two
/// one-sided limits are the values of the two segments there, so callers name the segment and never compare
/// times.
class Input {
 public:
  /// @param segments  not empty, contiguous (end of one == begin of the next, bit for bit)
  /// @throws std::invalid_argument naming the segment that breaks a rule (shape, order, gap, non-finite, unknown channel)
  Input(int channels, std::vector<InputSegment> segments);

  [[nodiscard]] int channels() const { return channels_; }
  [[nodiscard]] int segments() const { return static_cast<int>(segments_.size()); }
  [[nodiscard]] const InputSegment& segment(int index) const { return segments_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] double begin() const { return segments_.front().begin; }
  [[nodiscard]] double end() const { return segments_.back().end; }

  /// Value at t by the formula of that segment (t at its ends gives the one-sided limits).
  /// @param u  shape (2 w): heights and rates, or (3 w): accelerations too
  void evaluate(int segment, double t, std::span<double> u) const;

  /// Heights and rates at the samples first .. first+count-1 of the grid t0 + i dt in one sweep. Block b of the
  /// grid is seeded with one sine and cosine per frequency at t0 + (b kBlock) dt; within it a rotation leads from
  /// sample to sample, so a value depends on t0, dt and its index i alone and never on where a caller cuts a
  /// long sweep. Differs from evaluate(t0 + i dt) by at most sweepError().
  /// @param first  a multiple of kBlock, >= 0
  /// @param u      (count x 2 w), row-major
  void sweep(int segment, double t0, double dt, int first, int count, std::span<double> u) const;
  void sweep(int segment, double t0, double dt, int count, std::span<double> u) const {
    sweep(segment, t0, dt, 0, count, u);
  }
  static constexpr int kBlock = 64;

  /// sweep() in two halves, for callers that need some channels at a time: the clock of its samples once, then rows from it.
  /// Allocates only where `clock` is smaller than ever before.
  /// @param first, count  as for sweep()
  void prepare(int segment, double t0, double dt, int first, int count, PhasorTable& clock) const;
  /// Heights of the channels from .. to-1, then their rates, at one sample of the clock: the bits that sweep() gives,
  /// however the channels are cut. Never allocates and never throws without sampled terms.
  /// @param sample  0 <= sample < clock.count   @param u  (2 (to - from))
  void readRow(const PhasorTable& clock, int sample, int from, int to, double* u) const;

  /// The same input with its channels in another order: channel i of the result is channel order[i] of this one.
  /// @throws std::invalid_argument unless order names every channel once
  [[nodiscard]] Input inOrder(std::span<const int> order) const;

  /// Bound of |sweep - evaluate| for one channel [m]; for its rate multiply each term by its frequency.
  ///     sum_f hypot(cosine, sine) (4 kBlock + 8 w_f T) 2^-53,     T = largest |t|, |t - begin|, count dt of the sweep
  /// 4 kBlock: a rotation rounds and its own coefficients are rounded. 8 w_f T: both sides round the time and the
  /// phase w_f (t - begin), the sweep w_f dt too, once a sample.
  [[nodiscard]] static double sweepError(double amplitude, double angular_frequency, double largest_time) {
    return amplitude * (4.0 * kBlock + 8.0 * angular_frequency * largest_time) * 0x1p-53;
  }

 private:
  // The coefficients of a segment once more, laid out as the sums run: rows of 2 w (heights, rates), so that one
  // pass over a row serves height and rate of every channel.
  struct Rows {
    std::size_t offset = 0;   // in rows_
    bool polynomial = false;  // four rows E0..E3 come first: value = E0 + s (E1 + s (E2 + s E3))
  };
  // @param acceleration  (w), or null where it is not wanted
  template <int kWidth>
  void evaluateRows(const InputSegment& segment, Rows rows, double t, double* u, double* acceleration) const;
  template <int kWidth>
  void sweepRows(const InputSegment& segment, Rows rows, double t0, double dt, int first, int count, double* u) const;
  void packRows(const InputSegment& segment);
  void addSampled(const InputSegment& segment, std::span<const double> t, double* u, int width) const;
  /// @throws std::invalid_argument unless a sweep may start and go on so
  static void requireSweep(int first, int count);

  int channels_;
  std::vector<InputSegment> segments_;
  std::vector<Rows> index_;    // shape (segments)
  std::vector<double> rows_;
};

/// An input known at equally spaced samples only (measured, random): a cubic Hermite hold between them.
/// Error of the hold O(dt^4) for a smooth rail. Every sample is a segment border.
/// @param height  [m]   (samples x channels), row-major, samples >= 2
/// @param rate    [m/s] (samples x channels), row-major
/// @throws std::invalid_argument on a wrong shape or a non-finite value, naming it
[[nodiscard]] Input storedInput(int channels, double t0, double dt, std::span<const double> height,
                                std::span<const double> rate);

}  // namespace vehicle
