#include "libvehicle/flat/flat_train.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "libvehicle/flat/flat_form.h"
#include "libvehicle/flat/flat_output.h"
#include "libvehicle/flat/flat_statics.h"
#include "libvehicle/flat/flat_train_layout.h"
#include "libvehicle/flat/flat_unit_response.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Couplings that carry no static load leave each vehicle to itself: the lever rule serves it.
bool carryNothing(const Topology& topology, const FlatTrainLayout& layout) {
  return std::all_of(layout.couplings.begin(), layout.couplings.end(), [&](int s) {
    return s < 0 || topology.suspensions[at(s)].preload == 0.0;
  });
}

/// Static loads of every vehicle.
std::vector<FlatLoads> loadsOf(const CompiledModel& model, const FlatTrainLayout& layout, bool each_for_itself) {
  std::vector<FlatLoads> loads;
  for (const FlatTrainVehicle& each : layout.vehicles) {
    const std::optional<FlatLoads> lever =
        each_for_itself ? leverRule(each.own, each.own_layout, model.gravity) : std::nullopt;
    loads.push_back(lever ? *lever : loadsAtRest(model.rest, each.layout));
  }
  return loads;
}

/// The columns of a coupling. Its force counts from its upper carbody, which need not be the one ahead.
struct CouplingColumns {
  int deflection = -1;  // -1: there is none
  int force = -1;
  double sign = 1.0;  // of the elongation that the equations have
};

class CoupledVehicles final : public FlatTrain {
 public:
  CoupledVehicles(const CompiledModel& model, const FlatTrainLayout& layout) : model_(model) {
    const Topology& topology = model_.topology;
    const bool each_for_itself = carryNothing(topology, layout);
    const std::vector<FlatLoads> loads = loadsOf(model_, layout, each_for_itself);
    std::vector<FlatBodyNames> names;
    std::vector<int> state_order;
    std::vector<int> channel_order;
    for (std::size_t v = 0; v < layout.vehicles.size(); ++v) {
      const FlatLayout& each = layout.vehicles[v].layout;
      vehicles_.push_back(flatParameters(topology, each, loads[v]));
      if (!each_for_itself) vehicles_.back().k_g = model_.rest.pitch_stiffness[at(each.carbody)];
      columns_.emplace_back(model_, each, vehicles_.back(), loads[v]);
      const TopologyBody& carbody = topology.bodies[at(each.carbody)];
      const TopologyBody& front = topology.bodies[at(each.bogie[0])];
      const TopologyBody& rear = topology.bodies[at(each.bogie[1])];
      names.push_back({carbody.name, front.name, rear.name});
      for (const int q : {carbody.z_index, carbody.pitch_index, front.z_index, rear.z_index}) {
        state_order.insert(state_order.end(), {q, model_.states.rate(q)});
      }
      channel_order.insert(channel_order.end(), each.wheelset.begin(), each.wheelset.end());
    }
    for (std::size_t v = 0; v < layout.couplings.size(); ++v) addCoupling(layout, v);
    equations_.emplace(vehicles_, couplings_, names, std::move(state_order), std::move(channel_order));
  }

  int channels() const override { return equations_->channels(); }
  StateLayout layout() const override { return model_.states; }
  const std::vector<Channel>& states() const override { return model_.state_channels; }
  const std::vector<Channel>& outputs() const override { return model_.outputs.channels(); }
  const EquationSet* equations() const override { return &*equations_; }
  const std::vector<FlatParameters>& vehicles() const override { return vehicles_; }
  const std::vector<FlatCoupling>& couplings() const override { return couplings_; }

  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const override {
    const int count = static_cast<int>(vehicles_.size());
    const std::vector<int>& order = equations_->stateOrder();
    for (int v = 0; v < count; ++v) {
      const Neighbourhood near = gather(v, x, u);
      for (std::size_t i = 0; i < 8; ++i) dx[at(order[8 * at(v) + i])] = near.dx[i];
    }
  }

  void output(std::span<const double> x, std::span<const double> u, std::span<double> y) const override {
    const int count = static_cast<int>(vehicles_.size());
    const std::vector<int>& channel = equations_->channelOrder();
    for (int v = 0; v < count; ++v) {
      const Neighbourhood near = gather(v, x, u);
      // From (q, q') equation by equation to all q, then all q'.
      std::array<double, 8> own, slope;
      for (std::size_t i = 0; i < 4; ++i) {
        own[i] = near.x[8 + 2 * i];
        own[i + 4] = near.x[8 + 2 * i + 1];
        slope[i] = near.dx[2 * i];
        slope[i + 4] = near.dx[2 * i + 1];
      }
      std::array<double, 12> rail;
      std::copy(near.u.begin(), near.u.end(), rail.begin());
      for (std::size_t i = 0; i < 4; ++i) rail[8 + i] = u[at(channel[4 * at(v) + i]) + 2 * at(channels())];
      columns_[at(v)].write(own.data(), slope.data(), rail.data(), y);
      if (v + 1 < count) writeCoupling(v, near.x.data() + 8, near.x.data() + 16, y);
    }
  }

  std::optional<StateSpace> linear() const override {
    requireDense("flat", size());
    return unitResponses(*this);
  }

 private:
  /// A vehicle between its neighbours, in cut order. What there is none of stays zero.
  struct Neighbourhood {
    std::array<double, 24> x{};  // (q, q') of the vehicle ahead, its own, those of the vehicle behind
    std::array<double, 8> u{};
    std::array<double, 8> dx{};
  };

  Neighbourhood gather(int vehicle, std::span<const double> x, std::span<const double> u) const {
    Neighbourhood near;
    const int* order = equations_->stateOrder().data();
    const int* channel = equations_->channelOrder().data() + 4 * vehicle;
    const int last = static_cast<int>(vehicles_.size()) - 1;
    const auto take = [&](int from, std::size_t entries, std::size_t to) {
      for (std::size_t i = 0; i < entries; ++i) near.x[to + i] = x[at(order[8 * at(from) + i])];
    };
    constexpr std::size_t kCarbody = 4;  // of a neighbour only its carbody is read
    if (vehicle > 0) take(vehicle - 1, kCarbody, 0);
    take(vehicle, 8, 8);
    if (vehicle < last) take(vehicle + 1, kCarbody, 16);
    for (std::size_t i = 0; i < 4; ++i) {
      near.u[i] = u[at(channel[i])];
      near.u[i + 4] = u[at(channel[i]) + at(channels())];
    }
    EquationWindow window;
    window.first = FlatEquationSet::kEquationsOfVehicle * vehicle;
    window.last = window.first + FlatEquationSet::kEquationsOfVehicle;
    window.x = near.x.data();
    window.x_first = window.first - FlatEquationSet::kEquationsOfVehicle;
    window.u = near.u.data();
    window.u_first = FlatEquationSet::kChannelsOfVehicle * vehicle;
    window.u_count = FlatEquationSet::kChannelsOfVehicle;
    window.dx = near.dx.data();
    window.dx_first = window.first;
    equations_->derivative(window);
    return near;
  }

  void addCoupling(const FlatTrainLayout& layout, std::size_t ahead) {
    const int index = layout.couplings[ahead];
    if (index < 0) {
      couplings_.emplace_back();
      coupling_columns_.emplace_back();
      return;
    }
    const TopologySuspension& each = model_.topology.suspensions[at(index)];
    const bool upper_leads = each.upper == layout.vehicles[ahead].layout.carbody;
    couplings_.push_back({each.stiffness, each.damping, upper_leads ? -each.arm_upper : -each.arm_lower,
                          upper_leads ? each.arm_lower : each.arm_upper});
    coupling_columns_.push_back({model_.outputs.column(PartKind::kSuspension, index, Quantity::kDeflection),
                                 model_.outputs.column(PartKind::kSuspension, index, Quantity::kForce),
                                 upper_leads ? 1.0 : -1.0});
  }

  void writeCoupling(int vehicle, const double* ahead, const double* behind, std::span<double> y) const {
    const CouplingColumns& to = coupling_columns_[at(vehicle)];
    if (to.deflection < 0) return;
    const FlatCoupling& q = couplings_[at(vehicle)];
    const auto elongation = [&](int order) {
      return (ahead[order] - q.arm_ahead * ahead[order + 2]) - (behind[order] + q.arm_behind * behind[order + 2]);
    };
    y[at(to.deflection)] = to.sign * elongation(0);
    y[at(to.force)] = to.sign * (q.stiffness * elongation(0) + q.damping * elongation(1));
  }

  CompiledModel model_;
  std::vector<FlatParameters> vehicles_;
  std::vector<FlatCoupling> couplings_;
  std::vector<FlatOutput> columns_;
  std::vector<CouplingColumns> coupling_columns_;
  std::optional<FlatEquationSet> equations_;
};

}  // namespace

ProblemList flatSystemUnsupported(const Topology& topology) {
  if (!isTrain(topology)) return flatUnsupported(topology, FlatVariant::kConsistent);
  return readTrainLayout(topology).problems;
}

std::unique_ptr<System> buildFlatSystem(const CompiledModel& model) {
  if (isTrain(model.topology)) return buildFlatTrain(model);
  return buildFlatForm(model);
}

std::unique_ptr<FlatTrain> buildFlatTrain(const CompiledModel& train) {
  FlatTrainReading reading = readTrainLayout(train.topology);
  if (!reading.problems.empty()) throw InvalidInput(std::move(reading.problems));
  return std::make_unique<CoupledVehicles>(train, reading.layout);
}

}  // namespace vehicle
