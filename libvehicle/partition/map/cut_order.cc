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

CutRun::CutRun(const System& system, const Input& input, std::span<const double> x0)
    : set_(&equationsOf(system)), input_(&input) {
  checkChannels("rk4", system.channels(), input.channels());
  checkStart("rk4", x0, system.size());
  const std::vector<int>& channels = set_->channelOrder();
  bool identity = true;
  for (std::size_t i = 0; i < channels.size(); ++i) identity = identity && channels[i] == static_cast<int>(i);
  if (!identity) reordered_ = input.inOrder(channels);
  x0_.reserve(x0.size());
  for (const int entry : set_->stateOrder()) x0_.push_back(x0[static_cast<std::size_t>(entry)]);
}

}  // namespace vehicle
