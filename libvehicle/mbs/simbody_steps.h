#pragma once

#include <vector>

#include "libvehicle/integrate/drive.h"
#include "libvehicle/mbs/simbody_model.h"
#include "libvehicle/system/run_problem.h"

namespace vehicle {

/// Simbody's own Runge-Kutta-Merson as an integrator. Steps end on the ends of intervals, and after a breakpoint start
/// from the right-hand limit. What Simbody throws becomes RunFailed, with the time reached.
class SimbodySteps final : public DrivenByType<SimbodySteps> {
 public:
  /// @param model    the problem's system; looked at, like all of the problem
  /// @throws std::invalid_argument  unless 0 < accuracy < 1 and the input has the form's channels
  SimbodySteps(SimbodyModel& model, const RunProblem& problem, double accuracy);
  SimbodySteps(const SimbodySteps&) = delete;  // Simbody asks this one for the rail
  SimbodySteps& operator=(const SimbodySteps&) = delete;

  void restart(const Interval& at, std::span<const double> x) override;
  void advance(const Interval& interval) override;
  [[nodiscard]] std::span<const double> state() const override { return x_; }
  [[nodiscard]] Statistics statistics() const override;

 private:
  void requireNumbers() const;
  template <class Call>
  void simbody(Call call) const;

  SimbodyModel& model_;
  RunProblem problem_;
  double accuracy_;
  std::vector<double> x_;
  int segment_ = 0;
  double reached_ = 0.0;  // [s]
};

}  // namespace vehicle
