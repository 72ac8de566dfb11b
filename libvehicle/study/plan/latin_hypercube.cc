#include "libvehicle/study/plan/latin_hypercube.h"

#include <algorithm>
#include <cmath>

#include "libvehicle/study/plan/counted_random.h"

namespace vehicle {

namespace {

// Streams of random numbers that must not meet: the shuffle of a dimension and the places within its strata.
constexpr std::uint64_t kShuffle = 0x5348554646;
constexpr std::uint64_t kPlace = 0x504c414345;

}  // namespace

LatinHypercube::LatinHypercube(std::uint64_t size, std::size_t dimensions, std::uint64_t seed)
    : size_(size), seed_(seed) {
  for (std::size_t d = 0; d < dimensions; ++d) strata_.emplace_back(size, countedRandom(seed, kShuffle, d));
}

void LatinHypercube::point(std::uint64_t index, std::span<double> point) const {
  const auto count = static_cast<double>(size_);
  for (std::size_t d = 0; d < strata_.size(); ++d) {
    const auto stratum = static_cast<double>(strata_[d].at(index));
    const double place = unitInterval(countedRandom(seed_, kPlace + d, index));
    // Rounding up at the end of a stratum would put the point into the next one.
    point[d] = std::min((stratum + place) / count, std::nextafter((stratum + 1.0) / count, 0.0));
  }
}

}  // namespace vehicle
