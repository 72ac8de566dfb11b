#pragma once

#include <array>
#include <memory>

#include "libvehicle/flat/flat_form.h"
#include "libvehicle/system/input.h"
#include "libvehicle/system/schedule.h"

namespace vehicle::bench {

inline constexpr int kStates = FlatRhs::kStates;
using State = std::array<double, kStates>;

/// The paper's vehicle from its file on the extended two-harmonic rail at 20 m/s for 10 s, ready to run.
struct PaperCase {
  std::unique_ptr<FlatForm> form;
  Input input;
  Schedule every_step;  // an output sample every 1 ms
  Schedule whole;       // one output sample, at the end
  State exact{};        // state at the end by the exact method
  State peak{};         // largest |state| of the run, one by one

  /// Largest difference from the exact end state, as a share of each state's peak.
  [[nodiscard]] double errorOf(const State& end) const;
};

[[nodiscard]] const PaperCase& paperCase();

/// The rail as a fast peer would write it: one sine and one cosine an evaluation; the third harmonic by the
/// triple-angle formula, the delays by the addition theorem. u = (eta1..eta4, eta1'..eta4').
class OneSincosRail {
 public:
  OneSincosRail();
  void operator()(double t, double* u) const;

 private:
  std::array<double, 4> cos_delay_{}, sin_delay_{}, cos_delay3_{}, sin_delay3_{};
};

/// The equations over that rail as a peer's integrator calls them: dx/dt of x at t.
struct TimedEquations {
  FlatRhs rhs;
  OneSincosRail rail;
  void operator()(const State& x, State& dx, double t) const {
    double u[8];
    rail(t, u);
    rhs(x.data(), u, dx.data());
  }
};

}  // namespace vehicle::bench
