#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "libvehicle/system/system.h"

namespace vehicle::test {

/// All columns of a form at one instant, asked for by name; NaN where the form wrote nothing.
class Columns {
 public:
  Columns(const System& form, const std::vector<double>& x, const std::vector<double>& u)
      : form_(form), values_(form.outputs().size(), std::nan("")) {
    form.output(x, u, values_);
  }
  double operator[](const std::string& name) const {
    const auto& channels = form_.outputs();
    const auto found = std::find_if(channels.begin(), channels.end(), [&](const Channel& c) { return c.name == name; });
    if (found == channels.end()) throw std::invalid_argument("no column " + name);
    return values_[static_cast<std::size_t>(found - channels.begin())];
  }
  const std::vector<double>& all() const { return values_; }

 private:
  const System& form_;
  std::vector<double> values_;
};

}  // namespace vehicle::test
