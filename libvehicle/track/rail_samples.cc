#include "libvehicle/track/rail_samples.h"

#include <algorithm>

namespace vehicle {

void StoredSamples::read(std::int64_t first, std::span<double> heights) {
  std::copy_n(heights_.begin() + static_cast<std::ptrdiff_t>(first), heights.size(), heights.begin());
}

}  // namespace vehicle
