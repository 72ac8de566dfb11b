#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "libvehicle/system/equation_set.h"
#include "libvehicle/system/input.h"
#include "libvehicle/system/system.h"

// Systems that can be cut into equations and know no vehicle: masses joined by springs and dampers as one likes.
namespace vehicle::test {

/// Spring and damper between two masses.
struct MassLink {
  int one = 0;
  int other = 0;
  double stiffness = 0.0;  // per mass [1/s^2]
  double damping = 0.0;    // [1/s]
};

/// Masses of 1 kg, each on its own rail where it has a channel, no two alike. The System's order is turned round:
/// (q_last .. q_0, q'_last .. q'_0) and the last channel first, so that a mix-up of orders cannot hide.
class MassEquations : public EquationSet {
 public:
  /// @param railed  whether mass e has a channel
  MassEquations(int masses, const std::vector<MassLink>& links, const std::vector<bool>& railed, double stiffness)
      : links_of_(at(masses)) {
    for (const MassLink& link : links) {
      links_of_[at(link.one)].push_back(link);
      links_of_[at(link.other)].push_back({link.other, link.one, link.stiffness, link.damping});
    }
    for (int e = 0; e < masses; ++e) {
      Equation equation{.name = "body" + std::to_string(e / 2) + " motion " + std::to_string(e), .reads = {}};
      std::vector<char> reads(at(masses), 0);
      for (const MassLink& link : links_of_[at(e)]) reads[at(link.other)] = 1;
      for (int other = 0; other < masses; ++other) {
        if (reads[at(other)] != 0) equation.reads.push_back(other);
      }
      equation.first_channel = channels_;
      if (railed[at(e)]) ++channels_;
      equation.last_channel = channels_;
      equations_.push_back(equation);
      stiffness_.push_back(stiffness * (1.0 + 0.1 * std::sin(3.0 * e)));
      damping_.push_back(2.0 + std::cos(5.0 * e));
      state_order_.push_back(masses - 1 - e);
      state_order_.push_back(2 * masses - 1 - e);
    }
    for (int channel = 0; channel < channels_; ++channel) channel_order_.push_back(channels_ - 1 - channel);
  }

  int channels() const override { return channels_; }
  const std::vector<Equation>& equations() const override { return equations_; }
  const std::vector<int>& stateOrder() const override { return state_order_; }
  const std::vector<int>& channelOrder() const override { return channel_order_; }

  void derivative(const EquationWindow& window) const override {
    for (int e = window.first; e < window.last; ++e) {
      const double* x = window.x + 2 * (e - window.x_first);
      double force = -damping_[at(e)] * x[1] - stiffness_[at(e)] * x[0];
      for (const MassLink& link : links_of_[at(e)]) {
        const double* other = window.x + 2 * (link.other - window.x_first);
        force += link.stiffness * (other[0] - x[0]) + link.damping * (other[1] - x[1]);
      }
      const Equation& equation = equations_[at(e)];
      if (equation.last_channel > equation.first_channel) {
        const double* eta = window.u + (equation.first_channel - window.u_first);
        force += stiffness_[at(e)] * eta[0] + damping_[at(e)] * eta[window.u_count];
      }
      double* dx = window.dx + 2 * (e - window.dx_first);
      dx[0] = x[1];
      dx[1] = force;
    }
  }

 private:
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  int channels_ = 0;
  std::vector<std::vector<MassLink>> links_of_;
  std::vector<Equation> equations_;
  std::vector<double> stiffness_, damping_;
  std::vector<int> state_order_, channel_order_;
};

/// The same masses as a System, with matrices.
class MassGraph : public System {
 public:
  MassGraph(int masses, const std::vector<MassLink>& links, const std::vector<bool>& railed, double stiffness = 400.0)
      : set_(masses, links, railed, stiffness) {
    for (int e = 0; e < masses; ++e) states_.push_back({"part" + std::to_string(e) + ".z", "m"});
    for (int e = 0; e < masses; ++e) states_.push_back({"part" + std::to_string(e) + ".vz", "m/s"});
  }

  const MassEquations& set() const { return set_; }
  int channels() const override { return set_.channels(); }
  StateLayout layout() const override { return {.coordinates = static_cast<int>(set_.equations().size())}; }
  const std::vector<Channel>& states() const override { return states_; }
  const std::vector<Channel>& outputs() const override { return states_; }
  const EquationSet* equations() const override { return &set_; }

  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const override {
    std::vector<double> cut(x.size()), rail(u.size()), slope(x.size());
    const auto w = static_cast<std::size_t>(channels());
    const auto entry = [&](std::size_t i) { return static_cast<std::size_t>(set_.stateOrder()[i]); };
    for (std::size_t i = 0; i < x.size(); ++i) cut[i] = x[entry(i)];
    for (std::size_t c = 0; c < w; ++c) {
      const auto channel = static_cast<std::size_t>(set_.channelOrder()[c]);
      rail[c] = u[channel];
      rail[w + c] = u[w + channel];
    }
    set_.derivative({.first = 0, .last = set_.size() / 2, .x = cut.data(), .u = rail.data(), .u_count = channels(),
                     .dx = slope.data()});
    for (std::size_t i = 0; i < x.size(); ++i) dx[entry(i)] = slope[i];
  }
  void output(std::span<const double> x, std::span<const double>, std::span<double> y) const override {
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = x[i];
  }
  std::optional<StateSpace> linear() const override {
    const auto n = static_cast<Eigen::Index>(states_.size());
    StateSpace matrices{Eigen::MatrixXd(n, n), Eigen::MatrixXd(n, 2 * channels())};
    std::vector<double> x(states_.size(), 0.0), u(2 * static_cast<std::size_t>(channels()), 0.0);
    for (Eigen::Index i = 0; i < n; ++i) {
      x[static_cast<std::size_t>(i)] = 1.0;
      derivative(x, u, {matrices.A.col(i).data(), states_.size()});
      x[static_cast<std::size_t>(i)] = 0.0;
    }
    for (Eigen::Index i = 0; i < 2 * channels(); ++i) {
      u[static_cast<std::size_t>(i)] = 1.0;
      derivative(x, u, {matrices.B.col(i).data(), states_.size()});
      u[static_cast<std::size_t>(i)] = 0.0;
    }
    return matrices;
  }

 private:
  MassEquations set_;
  std::vector<Channel> states_;
};

/// Masses in a row, each joined to the next `reach` ones; every second one has a rail.
inline MassGraph massChain(int masses, int reach = 1, double stiffness = 400.0) {
  std::vector<MassLink> links;
  std::vector<bool> railed;
  for (int e = 0; e < masses; ++e) {
    railed.push_back(e % 2 == 0);
    for (int d = 1; d <= reach && e + d < masses; ++d) links.push_back({e, e + d, 100.0 + 7.0 * e, 1.0 + 0.1 * d});
  }
  return MassGraph(masses, links, railed, stiffness);
}

/// A ring with two chords: no order of its equations is a chain.
inline MassGraph massRing(int masses) {
  std::vector<MassLink> links;
  for (int e = 0; e < masses; ++e) links.push_back({e, (e + 1) % masses, 90.0 + 11.0 * e, 0.7});
  links.push_back({0, masses / 2, 50.0, 0.3});
  links.push_back({1, masses - 2, 70.0, 0.2});
  return MassGraph(masses, links, std::vector<bool>(static_cast<std::size_t>(masses), true));
}

/// The shape of one vehicle: 0 and 1 are joined to each other and to both 2 and 3, which stand on rails.
inline MassGraph massVehicle() {
  return MassGraph(4, {{0, 1, 30.0, 0.4}, {0, 2, 200.0, 3.0}, {0, 3, 210.0, 3.1}, {1, 2, 90.0, 1.0}, {1, 3, 80.0, 1.2}},
                   {false, false, true, true});
}

/// Two waves that reach channel after channel at breakpoints beside samples and steps, then a ramp; duration 0.75 s.
inline Input wavesWithBreakpoints(int channels) {
  std::vector<InputSegment> segments;
  double begin = 0.0;
  for (const double end : {0.1037, 0.25, 0.5291, 0.5291 + 0.13, 0.75}) {
    InputSegment segment;
    segment.begin = begin;
    segment.end = end;
    segment.angular_frequency = {5.0, 15.0};
    const int index = static_cast<int>(segments.size());
    for (int c = 0; c < channels; ++c) {
      const bool rolls = c % 4 < index;
      for (int f = 0; f < 2; ++f) {
        segment.cosine.push_back(rolls ? 1e-3 * std::cos(1.0 + c + f) : 0.0);
        segment.sine.push_back(rolls ? 2e-3 * std::sin(2.0 + c - f) : 0.0);
      }
      const double slope = index == 3 ? 0.01 * (1 + c) : 0.0;
      segment.polynomial.insert(segment.polynomial.end(), {0.0, slope, 0.0, index == 3 ? 0.3 : 0.0});
    }
    segments.push_back(std::move(segment));
    begin = end;
  }
  return Input(channels, std::move(segments));
}

}  // namespace vehicle::test
