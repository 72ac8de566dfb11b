#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/units/channel.h"

namespace vehicle {

// What a design that lacks values says in its one message: "METRIC, METRIC: REASON | METRIC: REASON".

/// @param columns  the metrics of a row
/// @param missing  metric, why it has no value; metrics of one reason are named together
[[nodiscard]] std::string gapMessage(const std::vector<Channel>& columns,
                                     const std::map<std::size_t, std::string>& missing);

/// The parts of such a message, each with its metrics.
[[nodiscard]] std::vector<std::string_view> gapsIn(std::string_view message);

}  // namespace vehicle
