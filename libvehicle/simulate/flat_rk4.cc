#include "libvehicle/simulate/flat_rk4.h"

#include <algorithm>
#include <array>
#include <vector>

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

}  // namespace

Statistics runFlatRk4(const FlatForm& form, const Input& input, const Schedule& schedule, FixedStep step,
                      std::span<const double> x0, const Observer& observe) {
  if (form.rhs() == nullptr) return runRk4(form, input, schedule, step, x0, observe);
  checkStart("rk4", x0, form.size());

  const std::array<int, 8>& order = form.stateOrder();
  std::array<double, 8> inner{};
  std::array<double, 8> outer{};
  for (std::size_t i = 0; i < inner.size(); ++i) inner[i] = x0[static_cast<std::size_t>(order[i])];
  const Observer observeInVehicleOrder = [&](int sample, int segment, double t, std::span<const double> x) {
    for (std::size_t i = 0; i < outer.size(); ++i) outer[static_cast<std::size_t>(order[i])] = x[i];
    return observe(sample, segment, t, outer);
  };
  Rk4<FlatRhs, FlatRhs::kStates> stepper(*form.rhs());
  return runFixedStep(stepper, reordered(input, form.wheelOrder()), schedule, step, inner, observeInVehicleOrder);
}

}  // namespace vehicle
