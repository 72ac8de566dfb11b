#include "benchmarks/train_case.h"

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

namespace vehicle::bench {
namespace {

constexpr double kSpacing = 12.0;  // [m]
constexpr double kSpeed = 20.0;    // [m/s]

std::vector<int> identity(int size) {
  std::vector<int> order(static_cast<std::size_t>(size));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

FlatEquationSet trainSet(int vehicles) {
  const auto count = static_cast<std::size_t>(vehicles);
  std::vector<FlatBodyNames> names;
  for (int v = 0; v < vehicles; ++v) {
    const std::string unit = "unit_" + std::to_string(v + 1) + ".";
    names.push_back({unit + "carbody", unit + "front_bogie", unit + "rear_bogie"});
  }
  const FlatCoupling coupling{50e3, 20e3, 0.5 * kSpacing, 0.5 * kSpacing};
  return FlatEquationSet(std::vector<FlatParameters>(count, paperParameters()),
                         std::vector<FlatCoupling>(count - 1, coupling), names, identity(8 * vehicles),
                         identity(4 * vehicles));
}

}  // namespace

FlatParameters paperParameters() {
  FlatParameters v;
  v.mk = 57e3;
  v.Jk = 70e3;
  v.m1 = v.m2 = 9e3;
  v.lf = v.lr = 3.725;
  v.cs1 = v.cs2 = 2660e3;
  v.bs1 = v.bs2 = 100e3;
  v.cp.fill(3040e3);
  v.bp.fill(30e3);
  return v;
}

TrainSystem::TrainSystem(int vehicles) : set_(trainSet(vehicles)) {
  for (int i = 0; i < set_.size(); ++i) states_.push_back({"state" + std::to_string(i), i % 2 == 0 ? "m" : "m/s"});
}

void TrainSystem::derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const {
  set_.derivative({.first = 0, .last = set_.size() / 2, .x = x.data(), .u = u.data(), .u_count = set_.channels(),
                   .dx = dx.data()});
}

void TrainSystem::output(std::span<const double> x, std::span<const double>, std::span<double> y) const {
  std::copy(x.begin(), x.end(), y.begin());
}

std::optional<StateSpace> TrainSystem::linear() const {
  const Eigen::Index n = set_.size();
  const Eigen::Index w = 2 * set_.channels();
  StateSpace matrices{Eigen::MatrixXd(n, n), Eigen::MatrixXd(n, w)};
  const Eigen::MatrixXd one_state = Eigen::MatrixXd::Identity(n, n);
  const Eigen::MatrixXd one_input = Eigen::MatrixXd::Identity(w, w);
  const std::vector<double> no_state(static_cast<std::size_t>(n), 0.0);
  const std::vector<double> no_input(static_cast<std::size_t>(w), 0.0);
  const auto size = static_cast<std::size_t>(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    derivative({one_state.col(i).data(), size}, no_input, {matrices.A.col(i).data(), size});
  }
  for (Eigen::Index i = 0; i < w; ++i) {
    derivative(no_state, {one_input.col(i).data(), static_cast<std::size_t>(w)}, {matrices.B.col(i).data(), size});
  }
  return matrices;
}

Input trainInput(int vehicles, double duration) {
  constexpr std::array<double, 4> kWheel = {0.0, 3.0, 7.45, 10.45};  // [m] behind the leading one
  const double w = 2.0 * std::numbers::pi * kSpeed / 25.0;
  InputSegment segment;
  segment.end = duration;
  segment.angular_frequency = {w, 3.0 * w};
  for (int v = 0; v < vehicles; ++v) {
    for (const double wheel : kWheel) {
      const double delay = (kSpacing * v + wheel) / kSpeed;
      for (const auto& [amplitude, order] : {std::pair{5e-3, 1.0}, std::pair{2e-3, 3.0}}) {
        // a sin(n w (t - delay))
        segment.cosine.push_back(-amplitude * std::sin(order * w * delay));
        segment.sine.push_back(amplitude * std::cos(order * w * delay));
      }
      segment.polynomial.insert(segment.polynomial.end(), InputSegment::kPolynomial, 0.0);
    }
  }
  return Input(4 * vehicles, {std::move(segment)});
}

}  // namespace vehicle::bench
