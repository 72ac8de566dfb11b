#pragma once

// Between baseline code and the kernels of an instruction set: plain pointers and counts, nothing else, because
// whatever is instantiated in a kernel file uses that file's instructions. Rows are arrays of `lanes` doubles, one
// design each, aligned to 64 bytes.

#include "libvehicle/ensemble/isa.h"

namespace vehicle::ensemble {

inline constexpr int kCoefficientRows = 23;  // FlatCoefficients, in the order of its members
inline constexpr int kStateRows = 8;
inline constexpr int kLoadRow = 0;           // rows of Block::extra: wheel loads, wheelset masses, point arms
inline constexpr int kMassRow = 4;
inline constexpr int kArmRow = 8;
inline constexpr int kExtraRows = 16;
inline constexpr int kMetricRows = 6;  // sum, sum of squares, lowest, highest; values two samples and one ago
inline constexpr int kRangeRows = 2;   // lowest wheel load [N]; largest motion as a share of what is allowed
inline constexpr int kLookRows = 3;    // of a Look

/// Columns to be computed.
struct Choice {
  const int* columns = nullptr;  // FlatColumn numbers (count)
  int count = 0;
  bool accelerations = false;  // which groups of them occur
  bool secondaries = false;
  bool wheels = false;
  bool points = false;
};

/// One register of designs.
struct Block {
  const double* coefficients = nullptr;  // (kCoefficientRows rows)
  const double* extra = nullptr;         // (kExtraRows rows)
  double* state = nullptr;               // (kStateRows rows)
  double* metrics = nullptr;             // (choice.count x kMetricRows rows)
  double* range = nullptr;               // (kRangeRows rows)
  double* failed = nullptr;              // (1 row) number of the first sample that is not finite; infinity
  double* stored = nullptr;              // (counted samples x choice.count rows) or null
};

/// How a sample is measured: its weight in the integrals [s], 0 where it does not count; one over the time to the sample
/// before it, and of that to the one before [1/s], 0 where there is none in its smooth part of the run.
template <class Number>
struct Look {
  Number weight{};
  Number per_last{};
  Number per_before{};
};

/// Steps over a rail that all lanes share, or none, and a sample behind them.
struct SharedLeg {
  const double* rail = nullptr;    // (2 steps + 1) x 8: heights and rates at begin, middle, end of each step
  const double* sample = nullptr;  // 12: heights, rates, accelerations at the end; null where it is no sample
  double h = 0.0;                  // [s]
  int steps = 0;
  int number = 0;                  // of the sample
  int stored = -1;                 // its row among those stored, or -1
  Look<double> look;
};

/// A rail that differs from lane to lane, as the force of each bogie's primaries:
///     F(s) = f0 + s (f1 + s (f2 + s f3)) + sum_f [ A_f cos(w_f s) + B_f sin(w_f s) ]        [N]
struct LaneRail {
  int frequencies = 0;
  bool polynomial = false;  // whether any lane has one
  /// (frequencies x 8 rows) cos, sin; turn by half a step: cos - 1, sin; A, B of the front bogie; of the rear one
  double* oscillator = nullptr;
  const double* wheel = nullptr;             // (frequencies x 9 rows) cosine, sine of wheels 1 to 4 [m]; w [rad/s]
  const double* force_polynomial = nullptr;  // (8 rows) front f0 to f3, rear
  const double* wheel_polynomial = nullptr;  // (16 rows) wheel 1 p0 to p3, ...
  const double* half_step = nullptr;         // (1 row) [s]; 0: this lane waits
  /// (4 rows) [s] since the segment's begin when the oscillators were seeded; half a step; half steps made since then;
  /// 1, or 0 in a lane that waits
  double* time = nullptr;
};

/// Equal intervals of `steps` steps, each with a sample at its end unless `looks` is null.
struct LaneLeg {
  int steps = 0;      // of an interval; 0: a sample alone
  int intervals = 1;
  const double* looks = nullptr;  // (intervals x kLookRows rows)
  int number = -1;  // of the first sample; negative: samples of some lanes alone, which are neither counted nor stored
  int stored = -1;  // its row among those stored; negative: -k begins to store k samples later
};

/// Steady state under one harmonic.
struct Harmonic {
  const double* w = nullptr;     // (1 row) [rad/s]; 0: the constant part
  const double* rail = nullptr;  // (8 rows) [m] real parts of wheels 1 to 4, imaginary parts
};

struct SteadyBlock {
  const double* coefficients = nullptr;  // as Block
  const double* extra = nullptr;         // as Block
  const double* masses = nullptr;        // (4 rows) mk, Jk, m1, m2
  double* motion = nullptr;              // (harmonics x 8 rows) zk, phi, z1, z2: real parts, imaginary parts; or null
  double* amplitude = nullptr;           // (harmonics x choice.count x 2 rows) or null
  double* metrics = nullptr;             // (choice.count x kMetricRows rows) mean, sum of |X|^2 / 2, lowest, highest
  double* range = nullptr;               // (kRangeRows rows) 1 where a wheel load, a motion may leave its range; or null
};

/// One instruction set.
struct Kernels {
  int lanes;
  int packs;  // blocks of one call of runShared
  /// @param blocks  (packs)
  void (*runShared)(const Block* blocks, const Choice& choice, const SharedLeg* legs, int count);
  void (*runLanes)(const Block& block, const Choice& choice, const LaneRail& rail, const LaneLeg& leg);
  /// @param symmetric  front and rear, and the axles of a bogie, are equal in every lane
  void (*steady)(const SteadyBlock& block, const Choice& choice, const Harmonic* harmonics, int count,
                 bool symmetric);
  /// Lowest and highest of sum_f Re[X_f e^(i order_f x)] over x = 2 pi n / samples.
  /// @param circle  (samples x count x 2) cos, sin of order_f x
  void (*extremes)(const SteadyBlock& block, const Choice& choice, const double* circle, int count, int samples);
};

[[nodiscard]] const Kernels& kernelsOf(Isa isa);

namespace v2 { extern const Kernels kKernels; }
namespace v3 { extern const Kernels kKernels; }
namespace v4 { extern const Kernels kKernels; }

}  // namespace vehicle::ensemble
