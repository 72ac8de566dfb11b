#pragma once

#include <span>
#include <utility>

#include "libvehicle/integrate/integrator.h"

namespace vehicle {

/// Steps of a system in other coordinates than those it is shown in: another order of its states, or bounce and pitch.
///
/// @tparam Map    inner(x) and outer(y): a state there and back, each valid until its next call; inner() checks x.
///                kSystems: how many systems its inner state is of, each of which is evaluated
/// @tparam Steps  an Integrator of the inner system
template <class Map, class Steps>
class MappedSteps final : public Integrator {
 public:
  /// @param input  of the inner system
  /// @param make   make(const Map&, const Input&): the steps
  template <class Make>
  MappedSteps(Map map, Input input, Make make)
      : map_(std::move(map)), input_(std::move(input)), steps_(make(map_, input_)) {}
  MappedSteps(const MappedSteps&) = delete;  // steps_ looks at input_
  MappedSteps& operator=(const MappedSteps&) = delete;

  void restart(const Interval& at, std::span<const double> x) override {
    steps_.restart(at, map_.inner(x));
    state_ = map_.outer(steps_.state());
  }
  void advance(const Interval& interval) override {
    steps_.advance(interval);
    state_ = map_.outer(steps_.state());
  }
  [[nodiscard]] std::span<const double> state() const override { return state_; }
  [[nodiscard]] Statistics statistics() const override { return ofAll(steps_.statistics()); }
  Statistics run(const Schedule& schedule, std::span<const double> x0, const Observer& observe) override {
    return ofAll(
        steps_.run(schedule, map_.inner(x0), [&](int sample, int segment, double t, std::span<const double> x) {
          return observe(sample, segment, t, map_.outer(x));
        }));
  }

 private:
  static Statistics ofAll(Statistics of_one) {
    of_one.evaluations *= Map::kSystems;
    return of_one;
  }

  Map map_;
  Input input_;
  Steps steps_;
  std::span<const double> state_;
};

}  // namespace vehicle
