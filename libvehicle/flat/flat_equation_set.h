#pragma once

#include <string>
#include <vector>

#include "libvehicle/flat/flat_model.h"
#include "libvehicle/system/equation_set.h"

namespace vehicle {

/// One vertical spring and damper between the carbodies of two neighbours in a train: equation (8.1) of
/// docs/theory/vertical.md. Its force is positive in elongation, its upper end being the one of the carbody ahead.
struct FlatCoupling {
  double stiffness = 0.0;   // [N/m]   >= 0
  double damping = 0.0;     // [N s/m] >= 0
  double arm_ahead = 0.0;   // [m] its end behind the CG of the carbody ahead
  double arm_behind = 0.0;  // [m] its end ahead of the CG of the carbody behind
};

/// What the bodies of one vehicle are called, for the names of the equations.
struct FlatBodyNames {
  std::string carbody = "carbody";
  std::string front_bogie = "front_bogie";
  std::string rear_bogie = "rear_bogie";
};

/// Equations (2)-(5) of one vehicle or of a train, cut into equations: four a vehicle, in the order bounce (2),
/// pitch (3), front bogie (4), rear bogie (5), the vehicles from the leading one on. State in cut order, vehicle by
/// vehicle: (zk, zk', phi, phi', z1, z1', z2, z2'). Channels in cut order, vehicle by vehicle: wheels 1 to 4.
/// All numbers come from the functions of equations.h, which give the same bits alone and together.
class FlatEquationSet final : public EquationSet {
 public:
  static constexpr int kEquationsOfVehicle = 4;
  static constexpr int kChannelsOfVehicle = 4;

  /// @param vehicles   from the leading one on; at least one
  /// @param couplings  coupling i joins vehicles i and i + 1; one fewer than vehicles
  /// @param names      of each vehicle's bodies: one per vehicle
  /// @param state_order, channel_order  as in EquationSet: permutations of 8 and 4 entries a vehicle
  /// @throws std::invalid_argument naming the argument that has another size or is no permutation
  FlatEquationSet(const std::vector<FlatParameters>& vehicles, const std::vector<FlatCoupling>& couplings,
                  const std::vector<FlatBodyNames>& names, std::vector<int> state_order,
                  std::vector<int> channel_order);

  [[nodiscard]] int vehicles() const { return static_cast<int>(vehicles_.size()); }
  [[nodiscard]] int channels() const override { return kChannelsOfVehicle * vehicles(); }
  [[nodiscard]] const std::vector<Equation>& equations() const override { return equations_; }
  [[nodiscard]] const std::vector<int>& stateOrder() const override { return state_order_; }
  [[nodiscard]] const std::vector<int>& channelOrder() const override { return channel_order_; }
  void derivative(const EquationWindow& window) const override;

 private:
  // A vehicle between its couplings; where it has none the coefficients are zero and nothing is read.
  struct Place {
    FlatCoefficients<double> own;
    FlatCouplingCoefficients<double> front;  // to the vehicle ahead
    FlatCouplingCoefficients<double> rear;   // to the vehicle behind
  };
  double forceAtFront(const EquationWindow& window, int vehicle) const;
  double forceAtRear(const EquationWindow& window, int vehicle) const;
  void oneEquation(const EquationWindow& window, int equation) const;
  void wholeVehicles(const EquationWindow& window, int first, int last) const;

  std::vector<Place> vehicles_;
  std::vector<Equation> equations_;
  std::vector<int> state_order_;
  std::vector<int> channel_order_;
};

}  // namespace vehicle
