#include "libvehicle/validation/ledger.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/simulate/forms.h"
#include "libvehicle/simulate/methods.h"

namespace vehicle {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kUlp = 0x1p-52;

// Richardson's estimate is the leading term; twice it covers the following ones at steps that resolve
// every mode (MotionRates::resolvingRk4Step).
constexpr double kRichardson = 2.0;
// First-order perturbation, evaluated with the peaks of the linear run: half as much again for the next order.
constexpr double kGeometry = 1.5;

const ExpectedError& errorOf(const RunKey& run) { return methodNamed(run.method).error; }

Index columnOf(const CaseSize& the_case, PartKind part, std::size_t index, Quantity quantity) {
  return the_case.model.outputs.column(part, static_cast<int>(index), quantity);
}

/// The column of velocity that an acceleration changes; -1 for other columns.
int accelerationLevel(const CaseSize& the_case, Index column) {
  const OutputLayout& outputs = the_case.model.outputs;
  const Quantity quantity = outputs.keys()[static_cast<std::size_t>(column)].quantity;
  const bool is_acceleration = quantity == Quantity::kZAcceleration || quantity == Quantity::kPitchAcceleration;
  return is_acceleration ? outputs.levelOf(static_cast<int>(column)) : -1;
}

/// Largest effect of a disturbance of the state's rates on every column: L e, and directly where a column is an
/// acceleration.
VectorXd columnsOf(const CaseSize& the_case, const VectorXd& rate_disturbance) {
  const Sensitivity& sensitivity = the_case.sensitivity;
  VectorXd size = sensitivity.L * rate_disturbance;
  for (Index i = 0; i < size.size(); ++i) {
    const int level = accelerationLevel(the_case, i);
    if (level >= 0) size(i) += sensitivity.C.row(level).cwiseAbs().dot(rate_disturbance);
  }
  return size;
}

/// Static loads and heights that a Simbody form carries through its sums, and that cancel but for rounding.
VectorXd staticTerms(const CaseSize& the_case) {
  const Topology& topology = the_case.model.topology;
  VectorXd rate = VectorXd::Zero(the_case.model.states.size());
  const auto add = [&](int body, double arm, double force) {
    const TopologyBody& part = topology.bodies[static_cast<std::size_t>(body)];
    if (part.z_index >= 0) rate(the_case.model.states.rate(part.z_index)) += force / part.mass;
    if (part.pitch_index >= 0)
      rate(the_case.model.states.rate(part.pitch_index)) += std::abs(arm) * force / part.pitch_inertia;
  };
  for (std::size_t s = 0; s < topology.suspensions.size(); ++s) {
    const TopologySuspension& suspension = topology.suspensions[s];
    const TopologyBody& upper = topology.bodies[static_cast<std::size_t>(suspension.upper)];
    const double force = std::abs(the_case.model.rest.suspension_load[s]) + suspension.stiffness * std::abs(upper.z);
    add(suspension.upper, suspension.arm_upper, force);
    if (suspension.lower_body >= 0) {
      add(suspension.lower_body, suspension.arm_lower, force);
    } else if (const TopologyWheelset& wheelset =
                   topology.wheelsets[static_cast<std::size_t>(suspension.lower_wheelset)];
               wheelset.z_index >= 0) {
      rate(the_case.model.states.rate(wheelset.z_index)) += force / wheelset.mass;
    }
  }
  return rate;
}

VectorXd roundingOf(const CaseSize& the_case, const RunKey& run, long steps) {
  const Sensitivity& sensitivity = the_case.sensitivity;
  const MotionSize& motion = the_case.motion;
  const Index wheels2 = sensitivity.matrices.B.cols();
  VectorXd rate(motion.state.size());
  if (errorOf(run).law == ErrorLaw::kNone) {
    // A matrix exponential is good to some ulps of the whole state, not of each entry, and the same matrix acts
    // at every sample: its error is systematic.
    const Index coordinates = the_case.model.states.coordinates;
    const double h = the_case.output_step;
    const double factor = kUlp * (8.0 + 4.0 * sensitivity.fastest * h) / h;
    rate.head(coordinates).setConstant(factor * motion.state.head(coordinates).maxCoeff());
    rate.tail(coordinates).setConstant(factor * motion.state.tail(coordinates).maxCoeff());
  } else {
    const double h = steps > 0 ? the_case.duration / static_cast<double>(steps) : run.step;
    rate = 2.0 * kUlp / h * motion.state;
  }
  VectorXd terms =
      sensitivity.matrices.A.cwiseAbs() * motion.state + sensitivity.matrices.B.cwiseAbs() * motion.input.head(wheels2);
  VectorXd sums = sensitivity.C.cwiseAbs() * motion.state + sensitivity.D.cwiseAbs() * motion.input +
                  sensitivity.static_output.cwiseAbs();
  if (isSimbodyForm(run.form)) {
    const VectorXd carried = staticTerms(the_case);
    terms += carried;
    for (Index i = 0; i < sums.size(); ++i) {
      const int level = accelerationLevel(the_case, i);
      if (level >= 0) sums(i) += sensitivity.C.row(level).cwiseAbs().dot(carried);
    }
    for (std::size_t s = 0; s < the_case.model.topology.suspensions.size(); ++s) {
      const TopologySuspension& suspension = the_case.model.topology.suspensions[s];
      const double height = std::abs(the_case.model.topology.bodies[static_cast<std::size_t>(suspension.upper)].z);
      sums(columnOf(the_case, PartKind::kSuspension, s, Quantity::kDeflection)) += height;
      sums(columnOf(the_case, PartKind::kSuspension, s, Quantity::kForce)) +=
          std::abs(the_case.model.rest.suspension_load[s]) + suspension.stiffness * height;
    }
  }
  rate += 4.0 * kUlp * terms;
  return columnsOf(the_case, rate) + 4.0 * kUlp * sums;
}

/// What an adaptive method allows each state to be wrong after one step.
VectorXd stepTolerance(const CaseSize& the_case, const RunKey& run) {
  const VectorXd& state = the_case.motion.state;
  if (errorOf(run).law == ErrorLaw::kTolerances) return (run.relative * state.array() + run.absolute).matrix();
  // Simbody holds displacements of unit scale, smaller ones to the absolute value, and velocities to the same times
  // the coordinate's own angular frequency.
  const StateLayout& layout = the_case.model.states;
  VectorXd tolerance(state.size());
  for (int j = 0; j < layout.coordinates; ++j) {
    const double own_frequency = std::sqrt(std::abs(the_case.sensitivity.matrices.A(layout.rate(j), j)));
    tolerance(j) = run.accuracy * std::max(1.0, state(j));
    tolerance(layout.rate(j)) = tolerance(j) * std::max(1.0, own_frequency);
  }
  return tolerance;
}

VectorXd integrationOf(const CaseSize& the_case, const RunKey& run, long steps, const VectorXd& step_difference) {
  const Sensitivity& sensitivity = the_case.sensitivity;
  const ExpectedError& error = errorOf(run);
  if (error.law == ErrorLaw::kNone) return VectorXd::Zero(sensitivity.C.rows());
  if (error.law == ErrorLaw::kStepHalving) {
    // Order 4: err(h) = 16/15 |y(h) - y(h/2)|, err(h/2) = 1/15 of it. A method that has lost its order has a
    // larger err(h/2) and falls outside there.
    const double ratio = std::exp2(error.order);
    return kRichardson * ((run.refine == 1 ? ratio : 1.0) / (ratio - 1.0)) * step_difference;
  }
  // An adaptive method keeps the error of each step within a tolerance. If every step erred by all of it, always
  // with the sign that hurts most, the vehicle would gather L (tolerance / step); a share of that is expected.
  const VectorXd tolerance = stepTolerance(the_case, run);
  const double steps_per_second = static_cast<double>(steps) / the_case.duration;
  const VectorXd worst = steps_per_second * (sensitivity.L * tolerance) + sensitivity.C.cwiseAbs() * tolerance;
  return error.share * worst;
}

VectorXd geometryOf(const CaseSize& the_case) {
  const Topology& topology = the_case.model.topology;
  const GeometryDisturbance left_out = geometryDisturbance(topology, the_case.model.rest, the_case.motion);
  VectorXd rate = VectorXd::Zero(the_case.model.states.size());
  for (const TopologyBody& body : topology.bodies) {
    if (body.z_index >= 0) rate(the_case.model.states.rate(body.z_index)) = left_out.force(body.z_index) / body.mass;
    if (body.pitch_index >= 0) {
      rate(the_case.model.states.rate(body.pitch_index)) = left_out.force(body.pitch_index) / body.pitch_inertia;
    }
  }
  for (const TopologyWheelset& wheelset : topology.wheelsets) {
    if (wheelset.z_index >= 0) {
      rate(the_case.model.states.rate(wheelset.z_index)) = left_out.force(wheelset.z_index) / wheelset.mass;
    }
  }
  VectorXd size = columnsOf(the_case, rate);
  const auto add = [&](PartKind part, std::size_t index, Quantity quantity, double value) {
    size(columnOf(the_case, part, index, quantity)) += value;
  };
  for (std::size_t s = 0; s < topology.suspensions.size(); ++s) {
    const TopologySuspension& suspension = topology.suspensions[s];
    const Index row = static_cast<Index>(s);
    add(PartKind::kSuspension, s, Quantity::kDeflection, left_out.deflection(row));
    add(PartKind::kSuspension, s, Quantity::kForce, left_out.suspension_force(row));
    if (suspension.lower_wheelset >= 0) {
      const auto wheelset = static_cast<std::size_t>(suspension.lower_wheelset);
      add(PartKind::kWheelset, wheelset, Quantity::kLoad, left_out.suspension_force(row));
    }
  }
  for (std::size_t p = 0; p < topology.points.size(); ++p) {
    const TopologyPoint& point = topology.points[p];
    const TopologyBody& body = topology.bodies[static_cast<std::size_t>(point.body)];
    if (body.pitch_index < 0) continue;
    const double arm = std::abs(point.arm);
    const double pitch = the_case.motion.state(body.pitch_index);
    const double rate_of = the_case.motion.state(the_case.model.states.rate(body.pitch_index));
    add(PartKind::kPoint, p, Quantity::kZ, arm * std::pow(pitch, 3) / 6.0);
    add(PartKind::kPoint, p, Quantity::kZRate, arm * pitch * pitch / 2.0 * rate_of);
    const double pitch_acc = the_case.motion.output(
        columnOf(the_case, PartKind::kBody, static_cast<std::size_t>(point.body), Quantity::kPitchAcceleration));
    add(PartKind::kPoint, p, Quantity::kZAcceleration,
        arm * (pitch * pitch / 2.0 * pitch_acc + pitch * rate_of * rate_of));
  }
  return kGeometry * size;
}

bool hasTrueGeometry(const std::string& form) { return isSimbodyForm(form) && !isLinearForm(form); }

std::string integrationWords(const RunKey& run) {
  const Method& method = methodNamed(run.method);
  if (hasFixedSteps(run)) {
    return fmt::format("{} at {:.4g} ms, by Richardson", method.family(), 1e3 * run.step / run.refine);
  }
  return fmt::format("{} at {:.0e}", run.method, method.reads.tolerances ? run.relative : run.accuracy);
}

std::string geometryWords(const CaseSize& the_case) {
  double pitch = 0.0;
  for (const TopologyBody& body : the_case.model.topology.bodies) {
    if (body.pitch_index >= 0) pitch = std::max(pitch, the_case.motion.state(body.pitch_index));
  }
  const bool heights = the_case.model.topology.has_heights;
  return fmt::format("{:.2g} mrad of pitch, ~ amplitude{}", 1e3 * pitch, heights ? " with heights" : "^2");
}

}  // namespace

const char* nameOf(Source source) {
  switch (source) {
    case Source::kRounding:
      return "rounding";
    case Source::kIntegration:
      return "integration";
    case Source::kGeometry:
      return "geometry";
  }
  return "";
}

std::string RunKey::text() const {
  std::string text = fmt::format("{} {}", form, method);
  if (!scheme.empty()) text += fmt::format(" {} x{}", scheme, threads);
  if (map != "auto") text += " map " + map;
  return refine == 1 ? text : text + " h/2";
}

bool hasFixedSteps(const RunKey& run) { return errorOf(run).law == ErrorLaw::kStepHalving; }

bool haveEqualBits(const RunKey& a, const RunKey& b) {
  const auto serial = [](RunKey key) {
    key.scheme.clear();
    key.threads = 1;
    key.map = "auto";
    return key;
  };
  return (!a.scheme.empty() || !b.scheme.empty()) && serial(a) == serial(b);
}

RunSize sizeOfRun(const CaseSize& the_case, const RunKey& run, long steps, const VectorXd& step_difference) {
  RunSize size;
  size.rounding = roundingOf(the_case, run, steps);
  size.input_rounding = columnsOf(the_case, the_case.sensitivity.matrices.B.cwiseAbs() * the_case.input_rounding);
  size.integration = integrationOf(the_case, run, steps, step_difference);
  size.geometry = hasTrueGeometry(run.form) ? geometryOf(the_case) : VectorXd::Zero(size.rounding.size());
  return size;
}

Expectation expectationOf(const CaseSize& the_case, const RunKey& a, const RunSize& a_size, const RunKey& b,
                          const RunSize& b_size) {
  const bool same_method = a.method == b.method;
  const bool same_steps = hasFixedSteps(a) && methodNamed(a.method).family() == methodNamed(b.method).family() &&
                          a.step == b.step && a.refine == b.refine;
  const bool same_geometry = hasTrueGeometry(a.form) == hasTrueGeometry(b.form);
  const VectorXd zero = VectorXd::Zero(a_size.rounding.size());
  if (haveEqualBits(a, b)) return {zero, zero, Source::kRounding, "equal bits: shared among threads in another way"};

  Expectation made;
  made.rounding = a_size.rounding + b_size.rounding;
  if (!same_method) made.rounding += a_size.input_rounding + b_size.input_rounding;
  const VectorXd integration = same_steps ? zero : VectorXd(a_size.integration + b_size.integration);
  const VectorXd geometry = same_geometry ? zero : VectorXd(a_size.geometry + b_size.geometry);
  made.size = made.rounding + integration + geometry;

  // Told is what matters where the expectation is largest against the column's peak; columns that are nothing but
  // rounding have no peak to speak of.
  Index worst = 0;
  double worst_share = -1.0;
  for (Index i = 0; i < made.size.size(); ++i) {
    const double peak = the_case.motion.output(i);
    if (peak <= made.rounding(i)) continue;
    if (const double share = made.size(i) / peak; share > worst_share) {
      worst_share = share;
      worst = i;
    }
  }
  struct Part {
    double size;
    Source source;
    std::string words;
  };
  std::vector<Part> parts = {{geometry(worst), Source::kGeometry, geometryWords(the_case)}};
  if (!same_steps) {
    if (a_size.integration(worst) > 0.0)
      parts.push_back({a_size.integration(worst), Source::kIntegration, integrationWords(a)});
    if (b_size.integration(worst) > 0.0)
      parts.push_back({b_size.integration(worst), Source::kIntegration, integrationWords(b)});
  }
  parts.push_back(
      {made.rounding(worst), Source::kRounding,
       same_steps ? fmt::format("same equations, same {} steps", methodNamed(a.method).family()) : "same equations"});
  std::stable_sort(parts.begin(), parts.end(), [](const Part& p, const Part& q) { return p.size > q.size; });
  made.source = parts.front().source;
  // A second part is worth a word from a tenth of the whole on.
  std::optional<Source> said;
  for (const Part& part : parts) {
    if (said && part.size <= 0.1 * made.size(worst)) continue;
    if (made.why.ends_with(part.words)) continue;
    if (said != part.source) made.why += fmt::format("{}{}: ", said ? "; " : "", nameOf(part.source));
    if (said == part.source) made.why += " + ";
    made.why += part.words;
    said = part.source;
  }
  return made;
}

}  // namespace vehicle
