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

std::optional<Index> columnOf(const std::vector<Channel>& columns, const std::string& name) {
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const Channel& c) { return c.name == name; });
  if (found == columns.end()) return std::nullopt;
  return found - columns.begin();
}

std::optional<Index> velocityOf(const std::vector<Channel>& columns, const std::string& name) {
  for (const auto& [rate, level] : {std::pair{".az", ".vz"}, std::pair{".pitch_acc", ".pitch_rate"}}) {
    if (!name.ends_with(rate)) continue;
    return columnOf(columns, name.substr(0, name.size() - std::string_view(rate).size()) + level);
  }
  return std::nullopt;
}

CaseSize sizeOfCase(const System& system, Topology topology, Rest rest, const Input& input,
                    const TimeHistory& reference, double output_step) {
  CaseSize made;
  made.topology = std::move(topology);
  made.rest = std::move(rest);
  made.columns = system.outputs();
  made.duration = reference.at(reference.samples() - 1, 0) - reference.at(0, 0);
  made.output_step = output_step;
  made.sensitivity = sensitivityOf(system, made.duration);

  const Index outputs = static_cast<Index>(made.columns.size());
  made.motion.output = VectorXd::Zero(outputs);
  for (std::size_t i = 0; i < reference.samples(); ++i) {
    const std::span<const double> row = reference.row(i);
    for (Index j = 0; j < outputs; ++j) {
      made.motion.output(j) = std::max(made.motion.output(j), std::abs(row[static_cast<std::size_t>(j) + 1]));
    }
  }
  made.motion.state = VectorXd::Zero(system.size());
  for (Index j = 0; j < made.motion.state.size(); ++j) {
    const auto column = columnOf(made.columns, system.states()[static_cast<std::size_t>(j)].name);
    if (column) made.motion.state(j) = made.motion.output(*column);
  }
  made.motion.suspension_force = VectorXd::Zero(static_cast<Index>(made.topology.suspensions.size()));
  for (std::size_t s = 0; s < made.topology.suspensions.size(); ++s) {
    const auto column = columnOf(made.columns, made.topology.suspensions[s].name + ".force");
    if (column) made.motion.suspension_force(static_cast<Index>(s)) = made.motion.output(*column);
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
