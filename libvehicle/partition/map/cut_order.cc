#include "libvehicle/partition/map/cut_order.h"

#include <stdexcept>

#include "libvehicle/integrate/failure.h"

namespace vehicle {

const EquationSet& equationsOf(const System& system) {
  const EquationSet* set = system.equations();
  if (set != nullptr) return *set;
  throw std::invalid_argument(
      "partition: the system cannot be cut into equations; run it on one thread, without a scheme");
}

CutRun::CutRun(const RunProblem& problem) : set_(&equationsOf(problem.system)), input_(&problem.input) {
  checkChannels("rk4", problem.system.channels(), problem.input.channels());
  checkStart("rk4", problem.x0, problem.system.size());
  const std::vector<int>& channels = set_->channelOrder();
  bool identity = true;
  for (std::size_t i = 0; i < channels.size(); ++i) identity = identity && channels[i] == static_cast<int>(i);
  if (!identity) reordered_ = problem.input.inOrder(channels);
  x0_.reserve(problem.x0.size());
  for (const int entry : set_->stateOrder()) x0_.push_back(problem.x0[static_cast<std::size_t>(entry)]);
}

}  // namespace vehicle
