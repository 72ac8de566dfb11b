#pragma once

#include <span>
#include <vector>

#include "libvehicle/system/system.h"
#include "tests/support/paper_matrices.h"

namespace vehicle::test {

/// A system that is asked for its size alone: eight states, no equations to share.
class EightStates final : public System {
 public:
  int channels() const override { return 4; }
  StateLayout layout() const override { return {.coordinates = 4}; }
  const std::vector<Channel>& states() const override { return states_; }
  const std::vector<Channel>& outputs() const override { return states_; }
  void derivative(std::span<const double>, std::span<const double>, std::span<double>) const override {}
  void output(std::span<const double>, std::span<const double>, std::span<double>) const override {}

 private:
  std::vector<Channel> states_ = paperStates();
};

}  // namespace vehicle::test
