#pragma once

#include <memory>
#include <span>
#include <vector>

#include "libvehicle/integrate/drive.h"
#include "libvehicle/integrate/exact.h"

namespace vehicle {

/// Exact propagation from interval to interval.
///
/// Propagators of a segment with harmonics live as long as the segment; without harmonics they and the polynomial gains
/// know nothing of the segment and are kept, so that thousands of stored samples share one.
class ExactSteps final : public DrivenByType<ExactSteps> {
 public:
  /// @throws std::invalid_argument  if system.linear() is empty, or the input does not fit
  ExactSteps(const System& system, const Input& input);

  void restart(const Interval& at, std::span<const double> x) override;
  void advance(const Interval& interval) override;
  [[nodiscard]] std::span<const double> state() const override {
    return {x_.data(), static_cast<std::size_t>(x_.size())};
  }
  [[nodiscard]] Statistics statistics() const override { return statistics_; }

 private:
  void enter(int segment);
  void catchUp(const Interval& interval);
  ExactPropagator& propagatorFor(double length, double whole);
  const PolynomialGain& gainFor(double length);
  template <class List>
  void makeRoom(List& list);

  StateSpace matrices_;
  const Input& input_;
  Eigen::VectorXd x_;
  Eigen::VectorXd u_;
  Eigen::VectorXd slope_;
  Statistics statistics_;
  double lag_ = 0.0;  // [s] by which x_ is behind the clock

  int segment_ = -1;
  bool harmonic_ = false;
  bool polynomial_ = false;
  Eigen::MatrixXd forcing_;
  std::vector<double> oscillators_;
  const ExactPropagator* seeded_ = nullptr;  // the one that turns the oscillators now
  int turns_ = 0;

  // By pointer: seeded_ and callers keep looking at one while its list grows.
  std::vector<std::unique_ptr<ExactPropagator>> of_segment_;
  std::vector<std::unique_ptr<ExactPropagator>> free_;
  std::vector<std::unique_ptr<PolynomialGain>> gains_;
};

}  // namespace vehicle
