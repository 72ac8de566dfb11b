#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "libvehicle/integrate/run.h"
#include "tests/support/truths.h"

namespace vehicle::test {

/// The state as runs and observers pass it.
using States = std::span<const double>;

/// dx/dt as an expression that both a static stepper and a System can call.
using Expression = std::function<void(const double* x, const double* u, double* dx)>;

/// A system made of an expression, with or without matrices.
class ExpressionSystem : public System {
 public:
  ExpressionSystem(int states, int channels, Expression expression)
      : channels_(channels), expression_(std::move(expression)) {
    for (int i = 0; i < states; ++i) states_.push_back({"part" + std::to_string(i) + ".z", "m"});
  }
  [[nodiscard]] int channels() const override { return channels_; }
  /// An expression may be of first order: its states are the rates of nothing.
  [[nodiscard]] StateLayout layout() const override { return {.internal = static_cast<int>(states_.size())}; }
  [[nodiscard]] const std::vector<Channel>& states() const override { return states_; }
  [[nodiscard]] const std::vector<Channel>& outputs() const override { return states_; }
  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const override {
    expression_(x.data(), u.data(), dx.data());
  }
  void output(std::span<const double> x, std::span<const double>, std::span<double> y) const override {
    std::copy(x.begin(), x.end(), y.begin());
  }

 private:
  int channels_;
  Expression expression_;
  std::vector<Channel> states_;
};

/// x' = A x + B u.
class MatrixSystem : public ExpressionSystem {
 public:
  explicit MatrixSystem(StateSpace matrices)
      : ExpressionSystem(static_cast<int>(matrices.A.rows()), static_cast<int>(matrices.B.cols() / 2),
                         [matrices](const double* x, const double* u, double* dx) {
                           for (Eigen::Index i = 0; i < matrices.A.rows(); ++i) {
                             dx[i] = 0.0;
                             for (Eigen::Index j = 0; j < matrices.A.cols(); ++j) dx[i] += matrices.A(i, j) * x[j];
                             for (Eigen::Index j = 0; j < matrices.B.cols(); ++j) dx[i] += matrices.B(i, j) * u[j];
                           }
                         }),
        matrices_(std::move(matrices)) {}
  [[nodiscard]] std::optional<StateSpace> linear() const override { return matrices_; }

 private:
  StateSpace matrices_;
};

inline StateSpace matricesOf(const DrivenMass& one) {
  StateSpace matrices{Eigen::Matrix2d{{0.0, 1.0}, {-one.stiffness / one.mass, -one.damping / one.mass}},
                      Eigen::Matrix2d::Zero()};
  matrices.B.row(1) << one.rail_stiffness / one.mass, one.rail_damping / one.mass;
  return matrices;
}

inline StateSpace matricesOf(const TwoMasses& two) {
  const double k = two.stiffness / two.mass, kc = two.joint_stiffness / two.mass;
  const double c = two.damping / two.mass, cc = two.joint_damping / two.mass;
  return {Eigen::Matrix4d{{0.0, 0.0, 1.0, 0.0},
                          {0.0, 0.0, 0.0, 1.0},
                          {-k - kc, kc, -c - cc, cc},
                          {kc, -k - kc, cc, -c - cc}},
          Eigen::Matrix4d{{0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}, {k, 0.0, c, 0.0}, {0.0, k, 0.0, c}}};
}

/// The rails under all wheels as an input; all rails have the same borders.
inline Input inputOf(const std::vector<std::vector<RailPiece>>& rails) {
  std::vector<InputSegment> segments;
  for (std::size_t index = 0; index < rails.front().size(); ++index) {
    const RailPiece& leading = rails.front()[index];
    InputSegment segment;
    segment.begin = leading.begin;
    segment.end = leading.end;
    for (const RailPiece::Wave& wave : leading.waves) segment.angular_frequency.push_back(wave.angular_frequency);
    for (const auto& rail : rails) {
      for (const RailPiece::Wave& wave : rail[index].waves) {
        segment.cosine.push_back(wave.amplitude.real());
        segment.sine.push_back(-wave.amplitude.imag());
      }
      segment.polynomial.insert(segment.polynomial.end(), {rail[index].offset, rail[index].slope, 0.0, 0.0});
    }
    segments.push_back(std::move(segment));
  }
  return Input(static_cast<int>(rails.size()), std::move(segments));
}

/// A problem with its solution.
struct Case {
  std::string name;
  MatrixSystem system;
  Input input;
  std::vector<double> start;
  std::function<std::vector<double>(double t)> truth;
};

inline Case caseOf(std::string name, const DrivenMass& one, const std::vector<RailPiece>& rail, MassState start = {}) {
  return {std::move(name), MatrixSystem(matricesOf(one)), inputOf({rail}), {start.z, start.v}, [=](double t) {
            const MassState motion = one.at(start, rail, t);
            return std::vector<double>{motion.z, motion.v};
          }};
}

/// A mass with the frequency and damping of a carbody's bounce (1.3 Hz, 15 %) on its spring.
inline DrivenMass bounce() {
  const double m = 30e3, k = 2e6, c = 75e3;
  return {m, c, k, c, k};
}

// Breakpoints fall on neither samples nor steps: 0.3137 s, 0.4691 s beside multiples of 5 or 10 ms.
inline std::vector<RailPiece> flatRail(double end = 3.0) { return {{0.0, end, 0.0, 0.0, {}}}; }
inline std::vector<RailPiece> sineRail(double end = 3.0) {
  return {{0.0, end, 0.0, 0.0, {{5.0, {0.003, -0.004}}, {15.0, {0.0, -0.002}}}}};
}
inline std::vector<RailPiece> sineOnsetRail(double at = 0.3137) {
  return {{0.0, at, 0.0, 0.0, {}}, {at, 3.0, 0.0, 0.0, {{9.0, {0.0, -0.005}}}}};
}
inline std::vector<RailPiece> rampRail() {
  const double from = 0.3137, to = 0.4691, slope = 0.05;
  return {{0.0, from, 0.0, 0.0, {}}, {from, to, 0.0, slope, {}}, {to, 3.0, slope * (to - from), 0.0, {}}};
}
inline std::vector<RailPiece> halfSineDipRail() {
  const double w = std::acos(-1.0) / (0.4691 - 0.3137);
  return {{0.0, 0.3137, 0.0, 0.0, {}}, {0.3137, 0.4691, 0.0, 0.0, {{w, {0.0, 0.01}}}}, {0.4691, 3.0, 0.0, 0.0, {}}};
}

/// Two masses whose wheels reach the same sine 0.2291 s after one another.
inline Case twoMassesOnOnset() {
  const TwoMasses two{9e3, 30e3, 3e6, 20e3, 1e6};
  const double first = 0.3137, second = 0.5428, w = 14.0;
  const std::complex<double> sine(0.0, -0.005);
  const auto zero = [&](double begin, double end) { return RailPiece{begin, end, 0.0, 0.0, {{w, 0.0}}}; };
  const auto rolling = [&](double begin, double end, double since) {
    return RailPiece{begin, end, 0.0, 0.0, {{w, sine * std::polar(1.0, w * (begin - since))}}};
  };
  const std::vector<RailPiece> leading = {zero(0.0, first), rolling(first, second, first), rolling(second, 3.0, first)};
  const std::vector<RailPiece> trailing = {zero(0.0, first), zero(first, second), rolling(second, 3.0, second)};
  std::vector<RailPiece> mean = leading, difference = leading;
  for (std::size_t i = 0; i < leading.size(); ++i) {
    const std::complex<double> a = leading[i].waves[0].amplitude, b = trailing[i].waves[0].amplitude;
    mean[i].waves[0].amplitude = 0.5 * (a + b);
    difference[i].waves[0].amplitude = 0.5 * (a - b);
  }
  return {"two masses on onset", MatrixSystem(matricesOf(two)), inputOf({leading, trailing}), {0.0, 0.0, 0.0, 0.0},
          [=](double t) {
            const MassState p = two.mean().at({}, mean, t), d = two.difference().at({}, difference, t);
            return std::vector<double>{p.z + d.z, p.z - d.z, p.v + d.v, p.v - d.v};
          }};
}

inline std::vector<Case> allCases() {
  std::vector<Case> cases;
  cases.push_back(caseOf("decay", bounce(), flatRail(), {0.01, -0.05}));
  cases.push_back(caseOf("sine", bounce(), sineRail(), {0.002, 0.01}));
  cases.push_back(caseOf("sine onset", bounce(), sineOnsetRail()));
  cases.push_back(caseOf("ramp", bounce(), rampRail()));
  cases.push_back(caseOf("half-sine dip", bounce(), halfSineDipRail()));
  cases.push_back(twoMassesOnOnset());
  return cases;
}

/// Largest error of any state over all samples, relative to that state's largest value.
template <class Run>
double worstError(const Case& problem, double output_step, const Run& run) {
  const std::size_t n = problem.start.size();
  std::vector<double> error(n, 0.0), peak(n, 0.0);
  run(problem.system, problem.input, Schedule(problem.input, output_step), problem.start,
      [&](int, int, double t, std::span<const double> x) {
        const std::vector<double> truth = problem.truth(t);
        for (std::size_t i = 0; i < n; ++i) {
          error[i] = std::max(error[i], std::abs(x[i] - truth[i]));
          peak[i] = std::max(peak[i], std::abs(truth[i]));
        }
        return true;
      });
  double worst = 0.0;
  for (std::size_t i = 0; i < n; ++i) worst = std::max(worst, error[i] / peak[i]);
  return worst;
}

}  // namespace vehicle::test
