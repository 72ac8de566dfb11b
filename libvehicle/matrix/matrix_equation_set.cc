#include "libvehicle/matrix/matrix_equation_set.h"

#include <algorithm>
#include <numeric>

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Indices from the largest x to the smallest; equals keep their order.
std::vector<int> fromTheFront(const std::vector<double>& x) {
  std::vector<int> order(x.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return x[at(a)] > x[at(b)]; });
  return order;
}

/// Where each coordinate stands [m].
std::vector<double> placesOf(const Topology& topology) {
  std::vector<double> x(at(topology.coordinates), 0.0);
  for (const TopologyBody& body : topology.bodies) {
    if (body.z_index >= 0) x[at(body.z_index)] = body.x;
    if (body.pitch_index >= 0) x[at(body.pitch_index)] = body.x;
  }
  for (const TopologyWheelset& wheelset : topology.wheelsets) {
    if (wheelset.z_index >= 0) x[at(wheelset.z_index)] = wheelset.x;
  }
  return x;
}

std::vector<int> inverseOf(const std::vector<int>& order) {
  std::vector<int> inverse(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) inverse[at(order[i])] = static_cast<int>(i);
  return inverse;
}

}  // namespace

MatrixEquationSet::MatrixEquationSet(const CompiledModel& model, const SparseSecondOrder& matrices) {
  const Topology& topology = model.topology;
  const int n = topology.coordinates;
  const std::vector<int> order = fromTheFront(placesOf(topology));
  equation_of_ = inverseOf(order);
  std::vector<double> wheel_x;
  for (const TopologyWheelset& wheelset : topology.wheelsets) wheel_x.push_back(wheelset.x);
  channel_order_ = fromTheFront(wheel_x);
  const std::vector<int> channel_of = inverseOf(channel_order_);

  const auto addRow = [&](const std::vector<SecondOrderEntry>& row, const std::vector<int>& cut_of, double factor) {
    const auto begin = static_cast<std::ptrdiff_t>(entries_.size());
    for (const SecondOrderEntry& each : row) {
      if (each.stiffness == 0.0 && each.damping == 0.0) continue;
      entries_.push_back({cut_of[at(each.column)], each.column, factor * each.stiffness, factor * each.damping});
    }
    std::sort(entries_.begin() + begin, entries_.end(), [](const Entry& a, const Entry& b) { return a.cut < b.cut; });
    row_begin_.push_back(static_cast<int>(entries_.size()));
    return std::span<const Entry>(entries_).subspan(static_cast<std::size_t>(begin));
  };
  row_begin_.push_back(0);
  for (int e = 0; e < n; ++e) {
    const int q = order[at(e)];
    const double inverse_mass = 1.0 / matrices.mass[at(q)];
    Equation equation{.name = model.state_channels[at(q)].name, .reads = {}};
    for (const Entry& each : addRow(matrices.own[at(q)], equation_of_, -inverse_mass)) {
      if (each.cut != e) equation.reads.push_back(each.cut);
    }
    const std::span<const Entry> rail = addRow(matrices.rail[at(q)], channel_of, inverse_mass);
    if (!rail.empty()) {
      equation.first_channel = rail.front().cut;
      equation.last_channel = rail.back().cut + 1;
    }
    equations_.push_back(std::move(equation));
    state_order_.insert(state_order_.end(), {q, model.states.rate(q)});
  }
}

/// A displacement, or a height of the rail, and its rate.
struct MatrixEquationSet::Movement {
  double value = 0.0;
  double rate = 0.0;
};

template <class Displacement, class Rail>
inline double MatrixEquationSet::sum(int equation, Displacement displacement, Rail rail) const {
  const int* begin = row_begin_.data() + 2 * equation;
  const Entry* entry = entries_.data() + begin[0];
  double total = 0.0;
  for (const Entry* end = entries_.data() + begin[1]; entry != end; ++entry) {
    const Movement body = displacement(*entry);
    total += entry->stiffness * body.value + entry->damping * body.rate;
  }
  for (const Entry* end = entries_.data() + begin[2]; entry != end; ++entry) {
    const Movement wheel = rail(*entry);
    total += entry->stiffness * wheel.value + entry->damping * wheel.rate;
  }
  return total;
}

void MatrixEquationSet::derivative(const EquationWindow& window) const {
  for (int e = window.first; e < window.last; ++e) {
    const double acceleration = sum(
        e,
        [&](const Entry& each) {
          const double* x = window.x + 2 * (each.cut - window.x_first);
          return Movement{x[0], x[1]};
        },
        [&](const Entry& each) {
          const double* u = window.u + (each.cut - window.u_first);
          return Movement{u[0], u[window.u_count]};
        });
    double* dx = window.dx + 2 * (e - window.dx_first);
    dx[0] = window.x[2 * (e - window.x_first) + 1];
    dx[1] = acceleration;
  }
}

double MatrixEquationSet::acceleration(int q, const double* x, const double* u) const {
  const int n = static_cast<int>(equations_.size());
  const int w = channels();
  return sum(
      equation_of_[at(q)], [&](const Entry& each) { return Movement{x[each.own], x[n + each.own]}; },
      [&](const Entry& each) { return Movement{u[each.own], u[w + each.own]}; });
}

}  // namespace vehicle
