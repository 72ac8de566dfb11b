#include "libvehicle/simulate/flat_by_type.h"

#include <algorithm>
#include <array>
#include <vector>

#include "libvehicle/integrate/adaptive_run.h"
#include "libvehicle/integrate/dopri5.h"
#include "libvehicle/integrate/failure.h"
#include "libvehicle/integrate/fixed_step_run.h"
#include "libvehicle/integrate/rk4.h"

namespace vehicle {

namespace {

// Channel i of the result is channel order[i] of the input.
Input reordered(const Input& input, const std::array<int, 4>& order) {
  std::vector<InputSegment> segments;
  segments.reserve(static_cast<std::size_t>(input.segments()));
  for (int index = 0; index < input.segments(); ++index) {
    const InputSegment& from = input.segment(index);
    InputSegment to = from;
    const auto copyRow = [&](const std::vector<double>& source, std::vector<double>& target, std::size_t channel) {
      const std::size_t width = source.size() / order.size();
      std::copy_n(source.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(order[channel]) * width), width,
                  target.begin() + static_cast<std::ptrdiff_t>(channel * width));
    };
    for (std::size_t channel = 0; channel < order.size(); ++channel) {
      copyRow(from.cosine, to.cosine, channel);
      copyRow(from.sine, to.sine, channel);
      copyRow(from.polynomial, to.polynomial, channel);
    }
    segments.push_back(std::move(to));
  }
  return Input(input.channels(), std::move(segments));
}

// Runs in the form's inner order, shows in the vehicle's.
// @param run  callable as run(input, x0, observer), all in inner order
template <class Run>
Statistics runInInnerOrder(const FlatForm& form, const Input& input, std::span<const double> x0,
                           const Observer& observe, Run run) {
  const std::array<int, 8>& order = form.stateOrder();
  std::array<double, 8> inner{};
  std::array<double, 8> outer{};
  for (std::size_t i = 0; i < inner.size(); ++i) inner[i] = x0[static_cast<std::size_t>(order[i])];
  const Observer observeInVehicleOrder = [&](int sample, int segment, double t, std::span<const double> x) {
    for (std::size_t i = 0; i < outer.size(); ++i) outer[static_cast<std::size_t>(order[i])] = x[i];
    return observe(sample, segment, t, outer);
  };
  return run(reordered(input, form.wheelOrder()), inner, observeInVehicleOrder);
}

}  // namespace

Statistics runFlatRk4(const FlatForm& form, const Input& input, const Schedule& schedule, FixedStep step,
                      std::span<const double> x0, const Observer& observe) {
  if (form.rhs() == nullptr) return runRk4(form, input, schedule, step, x0, observe);
  checkStart("rk4", x0, form.size());
  return runInInnerOrder(form, input, x0, observe, [&](const Input& u, std::span<const double> x, const Observer& show) {
    Rk4<FlatRhs, FlatRhs::kStates> stepper(*form.rhs());
    return runFixedStep(stepper, u, schedule, step, x, show);
  });
}

Statistics runFlatDopri5(const FlatForm& form, const Input& input, const Schedule& schedule, Accuracy accuracy,
                         std::span<const double> x0, const Observer& observe) {
  if (form.rhs() == nullptr) return runDopri5(form, input, schedule, accuracy, x0, observe);
  checkStart("dopri5", x0, form.size());
  return runInInnerOrder(form, input, x0, observe, [&](const Input& u, std::span<const double> x, const Observer& show) {
    Dopri5<FlatRhs, FlatRhs::kStates> stepper(*form.rhs());
    return runAdaptive(stepper, u, schedule, accuracy, x, show);
  });
}

}  // namespace vehicle
