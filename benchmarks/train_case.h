#pragma once

#include <memory>
#include <vector>

#include "libvehicle/flat/flat_equation_set.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/system/input.h"
#include "libvehicle/system/system.h"

namespace vehicle::bench {

/// N of the paper's vehicles 12 m apart, coupled end to end by 50 kN/m and 20 kN s/m, on the paper's extended rail at
/// 20 m/s. State and channels are in cut order.
class TrainSystem : public System {
 public:
  explicit TrainSystem(int vehicles);

  [[nodiscard]] int channels() const override { return set_.channels(); }
  [[nodiscard]] StateLayout layout() const override {
    return {.coordinates = static_cast<int>(set_.equations().size())};
  }
  [[nodiscard]] const std::vector<Channel>& states() const override { return states_; }
  [[nodiscard]] const std::vector<Channel>& outputs() const override { return states_; }
  [[nodiscard]] const EquationSet* equations() const override { return &set_; }
  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const override;
  void output(std::span<const double> x, std::span<const double> u, std::span<double> y) const override;
  [[nodiscard]] std::optional<StateSpace> linear() const override;

 private:
  FlatEquationSet set_;
  std::vector<Channel> states_;
};

/// The paper's vehicle in numbers.
[[nodiscard]] FlatParameters paperParameters();

/// The rail under every wheel of such a train for that long.
[[nodiscard]] Input trainInput(int vehicles, double duration);

}  // namespace vehicle::bench
