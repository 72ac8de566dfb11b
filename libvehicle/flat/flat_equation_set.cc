#include "libvehicle/flat/flat_equation_set.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace vehicle {
namespace {

constexpr int kEquations = FlatEquationSet::kEquationsOfVehicle;
constexpr int kChannels = FlatEquationSet::kChannelsOfVehicle;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

void requireSize(const char* name, std::size_t size, std::size_t expected, const char* rule) {
  if (size == expected) return;
  throw std::invalid_argument("flat equation set: " + std::string(name) + " has " + std::to_string(size) +
                              " entries, must have " + std::to_string(expected) + ", " + rule);
}

void requirePermutation(const char* name, const std::vector<int>& order) {
  std::vector<char> seen(order.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int entry = order[i];
    if (entry < 0 || at(entry) >= order.size() || seen[at(entry)] != 0) {
      throw std::invalid_argument("flat equation set: " + std::string(name) + "[" + std::to_string(i) + "] = " +
                                  std::to_string(entry) + ", must name every entry from 0 to " +
                                  std::to_string(order.size() - 1) + " once");
    }
    seen[at(entry)] = 1;
  }
}

// (q, q') of the first equation of a vehicle.
inline const double* stateOf(const EquationWindow& window, int vehicle) {
  return window.x + 2 * (kEquations * vehicle - window.x_first);
}

// The carbody alone: all that a neighbour reads, and all of a bogie's carbody.
inline FlatState<double> carbodyOf(const double* x) {
  return {.zk = x[0], .phi = x[2], .z1 = 0.0, .z2 = 0.0, .dzk = x[1], .dphi = x[3], .dz1 = 0.0, .dz2 = 0.0};
}

inline FlatState<double> vehicleOf(const double* x) {
  return {.zk = x[0], .phi = x[2], .z1 = x[4], .z2 = x[6], .dzk = x[1], .dphi = x[3], .dz1 = x[5], .dz2 = x[7]};
}

// The rail under the axles of one bogie; the other bogie's equation does not read it.
inline FlatRail<double> railUnderFront(const EquationWindow& window, int vehicle) {
  const double* eta = window.u + (kChannels * vehicle - window.u_first);
  const double* rate = eta + window.u_count;
  return {.eta1 = eta[0], .eta2 = eta[1], .eta3 = 0.0, .eta4 = 0.0,
          .deta1 = rate[0], .deta2 = rate[1], .deta3 = 0.0, .deta4 = 0.0};
}

inline FlatRail<double> railUnderRear(const EquationWindow& window, int vehicle) {
  const double* eta = window.u + (kChannels * vehicle - window.u_first);
  const double* rate = eta + window.u_count;
  return {.eta1 = 0.0, .eta2 = 0.0, .eta3 = eta[2], .eta4 = eta[3],
          .deta1 = 0.0, .deta2 = 0.0, .deta3 = rate[2], .deta4 = rate[3]};
}

}  // namespace

FlatEquationSet::FlatEquationSet(const std::vector<FlatParameters>& vehicles,
                                 const std::vector<FlatCoupling>& couplings, const std::vector<FlatBodyNames>& names,
                                 std::vector<int> state_order, std::vector<int> channel_order)
    : state_order_(std::move(state_order)), channel_order_(std::move(channel_order)) {
  if (vehicles.empty()) throw std::invalid_argument("flat equation set: no vehicles, must have at least one");
  const std::size_t count = vehicles.size();
  requireSize("couplings", couplings.size(), count - 1, "one between every two neighbours");
  requireSize("names", names.size(), count, "one a vehicle");
  requireSize("state_order", state_order_.size(), 2 * kEquations * count, "8 a vehicle");
  requireSize("channel_order", channel_order_.size(), kChannels * count, "4 a vehicle");
  requirePermutation("state_order", state_order_);
  requirePermutation("channel_order", channel_order_);

  const int last = static_cast<int>(count) - 1;
  for (int v = 0; v <= last; ++v) {
    Place place{.own = coefficientsOf(vehicles[at(v)]), .front = {}, .rear = {}};
    const auto coefficients = [&](const FlatCoupling& coupling) {
      return FlatCouplingCoefficients<double>{.c = coupling.stiffness, .b = coupling.damping,
                                              .arm_ahead = coupling.arm_ahead, .arm_behind = coupling.arm_behind};
    };
    if (v > 0) place.front = coefficients(couplings[at(v - 1)]);
    if (v < last) place.rear = coefficients(couplings[at(v)]);
    vehicles_.push_back(place);

    const int e = kEquations * v;
    const int channel = kChannels * v;
    const auto carbody = [&](const char* what, int other) {
      Equation equation{.name = names[at(v)].carbody + what, .reads = {}};
      if (v > 0) equation.reads = {e - kEquations, e - kEquations + 1};
      equation.reads.insert(equation.reads.end(), {other, e + 2, e + 3});
      if (v < last) equation.reads.insert(equation.reads.end(), {e + kEquations, e + kEquations + 1});
      return equation;
    };
    equations_.push_back(carbody(" bounce (2)", e + 1));
    equations_.push_back(carbody(" pitch (3)", e));
    equations_.push_back({names[at(v)].front_bogie + " bounce (4)", {e, e + 1}, channel, channel + 2});
    equations_.push_back({names[at(v)].rear_bogie + " bounce (5)", {e, e + 1}, channel + 2, channel + 4});
  }
}

inline double FlatEquationSet::forceAtFront(const EquationWindow& window, int vehicle) const {
  if (vehicle == 0) return 0.0;
  return couplingForce(vehicles_[at(vehicle)].front, carbodyOf(stateOf(window, vehicle - 1)),
                       carbodyOf(stateOf(window, vehicle)));
}

inline double FlatEquationSet::forceAtRear(const EquationWindow& window, int vehicle) const {
  if (vehicle + 1 == vehicles()) return 0.0;
  return couplingForce(vehicles_[at(vehicle)].rear, carbodyOf(stateOf(window, vehicle)),
                       carbodyOf(stateOf(window, vehicle + 1)));
}

void FlatEquationSet::oneEquation(const EquationWindow& window, int equation) const {
  const int vehicle = equation / kEquations;
  const int number = equation % kEquations;
  const Place& place = vehicles_[at(vehicle)];
  const double* x = stateOf(window, vehicle);
  const bool alone = vehicles_.size() == 1;
  double acceleration = 0.0;
  if (number == 0) {
    const FlatState<double> s = vehicleOf(x);
    acceleration = alone ? carbodyBounce(place.own, s)
                         : carbodyBounceInTrain(place.own, s, forceAtFront(window, vehicle),
                                                forceAtRear(window, vehicle));
  } else if (number == 1) {
    const FlatState<double> s = vehicleOf(x);
    acceleration = alone ? carbodyPitch(place.own, s)
                         : carbodyPitchInTrain(place.own, s, forceAtFront(window, vehicle), place.front.arm_behind,
                                               forceAtRear(window, vehicle), place.rear.arm_ahead);
  } else if (number == 2) {
    FlatState<double> s = carbodyOf(x);
    s.z1 = x[4];
    s.dz1 = x[5];
    acceleration = frontBogieBounce(place.own, s, railUnderFront(window, vehicle));
  } else {
    FlatState<double> s = carbodyOf(x);
    s.z2 = x[6];
    s.dz2 = x[7];
    acceleration = rearBogieBounce(place.own, s, railUnderRear(window, vehicle));
  }
  double* dx = window.dx + 2 * (equation - window.dx_first);
  dx[0] = x[2 * number + 1];
  dx[1] = acceleration;
}

void FlatEquationSet::wholeVehicles(const EquationWindow& window, int first, int last) const {
  const bool alone = vehicles_.size() == 1;
  double front_force = forceAtFront(window, first);
  for (int v = first; v < last; ++v) {
    const Place& place = vehicles_[at(v)];
    const FlatState<double> s = vehicleOf(stateOf(window, v));
    double* dx = window.dx + 2 * (kEquations * v - window.dx_first);
    const double* eta = window.u + (kChannels * v - window.u_first);
    const double* rate = eta + window.u_count;
    const FlatRail<double> rail{eta[0], eta[1], eta[2], eta[3], rate[0], rate[1], rate[2], rate[3]};
    const double rear_force = forceAtRear(window, v);
    double bounce = 0.0;
    double pitch = 0.0;
    if (alone) {
      bounce = carbodyBounce(place.own, s);
      pitch = carbodyPitch(place.own, s);
    } else {
      bounce = carbodyBounceInTrain(place.own, s, front_force, rear_force);
      pitch = carbodyPitchInTrain(place.own, s, front_force, place.front.arm_behind, rear_force,
                                  place.rear.arm_ahead);
    }
    const double front = frontBogieBounce(place.own, s, rail);
    const double rear = rearBogieBounce(place.own, s, rail);
    dx[0] = s.dzk;
    dx[1] = bounce;
    dx[2] = s.dphi;
    dx[3] = pitch;
    dx[4] = s.dz1;
    dx[5] = front;
    dx[6] = s.dz2;
    dx[7] = rear;
    front_force = rear_force;  // the same coupling, seen from its other end
  }
}

void FlatEquationSet::derivative(const EquationWindow& window) const {
  int e = window.first;
  const int whole = (window.first + kEquations - 1) / kEquations;
  const int whole_end = window.last / kEquations;
  if (whole < whole_end) {
    for (; e < kEquations * whole; ++e) oneEquation(window, e);
    wholeVehicles(window, whole, whole_end);
    e = kEquations * whole_end;
  }
  for (; e < window.last; ++e) oneEquation(window, e);
}

}  // namespace vehicle
