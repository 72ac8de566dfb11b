#include "libvehicle/validation/case_size.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

namespace vehicle {

using Eigen::Index;
using Eigen::VectorXd;

CaseSize sizeOfCase(const System& system, const CompiledModel& model, const Input& input, const TimeHistory& reference,
                    double output_step) {
  CaseSize made{model, {}, {}, {}, 0.0, 0.0};
  made.duration = reference.at(reference.samples() - 1, 0) - reference.at(0, 0);
  made.output_step = output_step;
  made.sensitivity = sensitivityOf(system, made.duration);

  const Index outputs = static_cast<Index>(model.outputs.size());
  made.motion.output = VectorXd::Zero(outputs);
  for (std::size_t i = 0; i < reference.samples(); ++i) {
    const std::span<const double> row = reference.row(i);
    for (Index j = 0; j < outputs; ++j) {
      made.motion.output(j) = std::max(made.motion.output(j), std::abs(row[static_cast<std::size_t>(j) + 1]));
    }
  }
  made.motion.state = VectorXd::Zero(model.states.size());
  for (Index j = 0; j < made.motion.state.size(); ++j) {
    made.motion.state(j) = made.motion.output(model.outputs.column(model.state_keys[static_cast<std::size_t>(j)]));
  }
  made.motion.suspension_force = VectorXd::Zero(static_cast<Index>(model.topology.suspensions.size()));
  for (int s = 0; s < static_cast<int>(model.topology.suspensions.size()); ++s) {
    const int column = model.outputs.column(PartKind::kSuspension, s, Quantity::kForce);
    made.motion.suspension_force(s) = made.motion.output(column);
  }

  const Index wheels = input.channels();
  made.motion.input = VectorXd::Zero(3 * wheels);
  made.input_rounding = VectorXd::Zero(2 * wheels);
  std::vector<double> u(static_cast<std::size_t>(3 * wheels));
  int segment = 0;
  for (std::size_t i = 0; i < reference.samples(); ++i) {
    const double t = reference.at(i, 0);
    while (segment + 1 < input.segments() && input.segment(segment).end <= t) ++segment;
    input.evaluate(segment, t, u);
    for (Index j = 0; j < 3 * wheels; ++j) {
      made.motion.input(j) = std::max(made.motion.input(j), std::abs(u[static_cast<std::size_t>(j)]));
    }
  }
  for (int s = 0; s < input.segments(); ++s) {
    const InputSegment& piece = input.segment(s);
    const std::size_t frequencies = piece.angular_frequency.size();
    for (Index wheel = 0; wheel < wheels; ++wheel) {
      double height = 0.0, rate = 0.0;
      for (std::size_t f = 0; f < frequencies; ++f) {
        const std::size_t at = static_cast<std::size_t>(wheel) * frequencies + f;
        const double omega = piece.angular_frequency[f];
        const double error = Input::sweepError(std::hypot(piece.cosine[at], piece.sine[at]), omega, piece.end);
        height += error;
        rate += omega * error;
      }
      made.input_rounding(wheel) = std::max(made.input_rounding(wheel), height);
      made.input_rounding(wheels + wheel) = std::max(made.input_rounding(wheels + wheel), rate);
    }
  }
  return made;
}

}  // namespace vehicle
