#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "libvehicle/flat/flat_form.h"
#include "libvehicle/flat/flat_order.h"
#include "libvehicle/flat/flat_output.h"
#include "libvehicle/flat/flat_statics.h"
#include "libvehicle/flat/flat_unit_response.h"

namespace vehicle {

/// What every reading of the equations shares: they count parts from the front, and a form's states, channels and
/// columns are in the vehicle's own order. Private to this room.
/// @tparam Equations  callable as FlatRhs is: equations(x, u, dx) of 8 doubles each in inner order, const
template <class Equations>
class OrderedForm : public FlatForm {
 public:
  int channels() const final { return model_.inputs.channels; }
  StateLayout layout() const final { return model_.states; }
  const std::vector<Channel>& states() const final { return model_.state_channels; }
  const std::vector<Channel>& outputs() const final { return model_.outputs.channels(); }
  const FlatParameters& parameters() const final { return parameters_; }
  const std::array<int, 8>& stateOrder() const final { return order_.state; }
  const std::array<int, 4>& wheelOrder() const final { return order_.wheel; }
  std::optional<StateSpace> linear() const final { return unitResponses(*this); }

  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const final {
    const Inner inner = innerDerivative(x, u.first(8));
    order_.scatterState(inner.dx, dx);
  }

  void output(std::span<const double> x, std::span<const double> u, std::span<double> y) const final {
    const Inner inner = innerDerivative(x, u.first(8));
    std::array<double, 12> rail;
    order_.gatherRail(u, rail);
    output_.write(inner.x.data(), inner.dx.data(), rail.data(), y);
  }

 protected:
  /// @param loads      flatLoads() of the layout   @param equations  of `parameters`
  OrderedForm(const CompiledModel& model, const FlatLayout& layout, const FlatLoads& loads,
              const FlatParameters& parameters, Equations equations)
      : model_(model),
        order_(model, layout),
        parameters_(parameters),
        rhs_(std::move(equations)),
        output_(model, layout, parameters, loads) {}

  [[nodiscard]] const Topology& topology() const { return model_.topology; }
  [[nodiscard]] const Equations& innerEquations() const { return rhs_; }

 private:
  /// State and derivative counted from the front.
  struct Inner {
    std::array<double, 8> x;
    std::array<double, 8> dx;
  };

  Inner innerDerivative(std::span<const double> x, std::span<const double> u) const {
    Inner inner;
    std::array<double, 8> rail;
    order_.gatherState(x, inner.x);
    order_.gatherRail(u, rail);
    rhs_(inner.x.data(), rail.data(), inner.dx.data());
    return inner;
  }

  CompiledModel model_;
  FlatOrder order_;
  FlatParameters parameters_;
  Equations rhs_;
  FlatOutput output_;
};

}  // namespace vehicle
