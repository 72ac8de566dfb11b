#pragma once

#include <complex>
#include <span>
#include <vector>

#include "libvehicle/ensemble/ensemble.h"
#include "libvehicle/system/input.h"

namespace vehicle {

enum class SteadyPeaks {
  kNone,     // lowest and highest stay 0
  kSampled,  // over the common period of the harmonics, which they must have (harmonic_orders.h): within 6e-5 of the
             // amplitude of the highest order
};
enum class SteadyAmplitudes { kDropped, kKept };
/// Whether designs are sorted out whose wheel loads or motions may leave what the model can say.
enum class SteadyDoubts { kIgnored, kTold };

/// What is asked of a steady state.
struct SteadyRun {
  std::vector<FlatColumn> columns;
  SteadyPeaks peaks = SteadyPeaks::kNone;
  SteadyAmplitudes amplitudes = SteadyAmplitudes::kDropped;
  SteadyDoubts doubts = SteadyDoubts::kIgnored;
  Isa isa = bestIsa();
};

/// A design without steady state on a rail: a harmonic meets an undamped mode, or a constant height a motion without
/// stiffness. Its summaries are NaN there.
struct SteadyFailure {
  int rail = 0;
  int design = 0;
};

/// What a design may do, by a bound that is never too small: |X| of all harmonics at once, within a factor of about two.
/// Without a doubt it does not.
struct SteadyDoubt {
  bool unloads = false;    // a wheel load below 0
  bool moves_far = false;  // beyond kMostFlatPitch or kMostFlatTravel
};

struct SteadyResult {
  /// (rails x designs x columns), row-major. The mean holds static loads and the rail's constant height.
  std::vector<ColumnSummary> summaries;
  /// Of each rail, where kept: complex amplitudes X of Re[X e^(i w (t - begin))], shape (designs x columns x harmonics
  /// of that rail), row-major.
  std::vector<std::vector<std::complex<double>>> amplitudes;
  std::vector<SteadyDoubt> doubts;      // (rails x designs) where asked for
  std::vector<SteadyFailure> failures;  // by rail, then by design
};

/// Steady state of many designs in closed form: (K + i w C - w^2 M) q = (B0 + i w B1) eta for every harmonic, one
/// design a SIMD lane. A symmetric design (front and rear, and all axles, equal in every bit) is two complex systems
/// of two, any other is one of four. The r.m.s. is sqrt(mean^2 + sum |X|^2 / 2): exact over a common period, and
/// the long-time value where there is none.
///
/// Every rail is applied to every design. Each has the 4 channels of the wheels 1 to 4, harmonics, and nothing else
/// but constant heights. A design gives the same bits in whatever company and order.
/// @throws std::invalid_argument for a rail with linear or higher terms or of another shape, and where peaks are asked
///         for and the harmonics have no common period
[[nodiscard]] SteadyResult steadyEnsemble(std::span<const EnsembleDesign> designs,
                                          std::span<const InputSegment* const> rails, const SteadyRun& run);

/// The same with a rail for each design, where wheel positions differ: summaries (designs x columns), one list of
/// amplitudes, where all rails must have as many harmonics.
/// @param rails  (designs), none null
[[nodiscard]] SteadyResult steadyEnsembleEach(std::span<const EnsembleDesign> designs,
                                              std::span<const InputSegment* const> rails, const SteadyRun& run);

}  // namespace vehicle
