#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "libvehicle/flat/flat_layout.h"
#include "libvehicle/model/compiled_model.h"

namespace vehicle {

/// Which entry of a vehicle's own state and input is which of the equations', which count parts from the front:
/// inner state (zk, phi, z1, z2, zk', phi', z1', z2'), inner wheels 1 to 4.
struct FlatOrder {
  std::array<int, 8> state{};
  std::array<int, 4> wheel{};

  FlatOrder(const CompiledModel& model, const FlatLayout& layout) : wheel(layout.wheelset) {
    const auto body = [&](int index) -> const TopologyBody& {
      return model.topology.bodies[static_cast<std::size_t>(index)];
    };
    const std::array<int, 4> place = {body(layout.carbody).z_index, body(layout.carbody).pitch_index,
                                      body(layout.bogie[0]).z_index, body(layout.bogie[1]).z_index};
    for (std::size_t i = 0; i < 4; ++i) {
      state[i] = place[i];
      state[i + 4] = model.states.rate(place[i]);
    }
  }

  /// Heights, rates and accelerations under the inner wheels, as far as u holds them.
  /// @param u  (4 n)   @param inner  (4 n)
  void gatherRail(std::span<const double> u, std::span<double> inner) const {
    for (std::size_t i = 0; i < inner.size(); ++i) inner[i] = u[i - i % 4 + static_cast<std::size_t>(wheel[i % 4])];
  }
  void gatherState(std::span<const double> x, std::span<double> inner) const {
    for (std::size_t i = 0; i < 8; ++i) inner[i] = x[static_cast<std::size_t>(state[i])];
  }
  void scatterState(std::span<const double> inner, std::span<double> x) const {
    for (std::size_t i = 0; i < 8; ++i) x[static_cast<std::size_t>(state[i])] = inner[i];
  }
};

}  // namespace vehicle
