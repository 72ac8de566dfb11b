#pragma once

#include <array>
#include <span>
#include <vector>

namespace vehicle {

/// What the rail does under every wheelset (channel) between two kinks, in closed form. With s = t - begin:
///
///     eta_j(t) = sum_k polynomial(j,k) s^k + sum_f [ cosine(j,f) cos(w_f s) + sine(j,f) sin(w_f s) ]
///
/// Frequencies are shared by all channels: a delay is another mixture of the same cosine and sine, so one
/// pair per frequency serves every wheel.
struct InputSegment {
  static constexpr int kPolynomial = 4;  // constant .. cubic (a cubic Hermite hold of stored samples)

  double begin = 0.0;                     // [s]
  double end = 0.0;                       // [s] > begin
  std::vector<double> angular_frequency;  // w_f [rad/s] > 0, distinct, shape (F)
  std::vector<double> cosine;             // [m] (channels x F), row-major
  std::vector<double> sine;               // [m] (channels x F), row-major
  std::vector<double> polynomial;         // [m, m/s, m/s^2, m/s^3] (channels x 4), row-major
};

/// The input u(t) of a system over a whole run, cut at its kinks.
///
/// u = (eta_1..eta_w, eta_1'..eta_w') [m, m/s]; where accelerations are asked for, eta_1''..eta_w'' [m/s^2]
/// follow. Inside a segment eta is analytic. At a kink eta is continuous and eta' or eta'' may jump: the two
/// one-sided limits are the values of the two segments there, so callers name the segment and never compare
/// times.
class Input {
 public:
  /// @param segments  not empty, contiguous (end of one == begin of the next, bit for bit)
  /// @throws std::invalid_argument naming the segment that breaks a rule (shape, order, gap, non-finite)
  Input(int channels, std::vector<InputSegment> segments);

  [[nodiscard]] int channels() const { return channels_; }
  [[nodiscard]] int segments() const { return static_cast<int>(segments_.size()); }
  [[nodiscard]] const InputSegment& segment(int index) const { return segments_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] double begin() const { return segments_.front().begin; }
  [[nodiscard]] double end() const { return segments_.back().end; }

  /// Value at t by the formula of that segment (t at its ends gives the one-sided limits).
  /// @param u  shape (2 w): heights and rates, or (3 w): accelerations too
  void evaluate(int segment, double t, std::span<double> u) const;

  /// Values at t0, t0 + dt, ..., t0 + (count-1) dt in one sweep: one sine and cosine per frequency and block of
  /// kBlock samples, a rotation from sample to sample within (each block is seeded anew, so errors stay at
  /// kBlock roundings). The values do not depend on how a caller cuts a long sweep at multiples of kBlock.
  /// @param u  (count x 2 w), row-major
  void sweep(int segment, double t0, double dt, int count, std::span<double> u) const;
  static constexpr int kBlock = 64;

 private:
  int channels_;
  std::vector<InputSegment> segments_;
};

/// An input known at equally spaced samples only (measured, random): a cubic Hermite hold between them.
/// Error of the hold O(dt^4) for a smooth rail. Every sample is a segment border.
/// @param height  [m]   (samples x channels), row-major, samples >= 2
/// @param rate    [m/s] (samples x channels), row-major
/// @throws std::invalid_argument on a wrong shape or a non-finite value, naming it
[[nodiscard]] Input storedInput(int channels, double t0, double dt, std::span<const double> height,
                                std::span<const double> rate);

}  // namespace vehicle
