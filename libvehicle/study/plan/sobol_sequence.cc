#include "libvehicle/study/plan/sobol_sequence.h"

#include <bit>
#include <stdexcept>

#include <boost/random/sobol.hpp>

#include "libvehicle/study/plan/counted_random.h"

namespace vehicle {

namespace {

constexpr std::uint64_t kShift = 0x5348494654;

}  // namespace

SobolSequence::SobolSequence(std::size_t dimensions, std::uint64_t seed) {
  if (dimensions < 1 || dimensions > kMostDimensions) {
    throw std::invalid_argument("SobolSequence: dimensions must be 1 .. 3667");
  }
  // Boost keeps its direction numbers v to itself, but point 2^k has the Gray code 2^k + 2^(k-1) and so is
  // v_k xor v_(k-1); Boost counts from the point after 0.
  boost::random::sobol engine(dimensions);
  directions_.resize(kBits * dimensions);
  for (unsigned bit = 0; bit < kBits; ++bit) {
    engine.seed((std::uint64_t{1} << bit) - 1);
    for (std::size_t d = 0; d < dimensions; ++d) {
      const std::uint64_t before = bit == 0 ? 0 : directions_[(bit - 1) * dimensions + d];
      directions_[bit * dimensions + d] = engine() ^ before;
    }
  }
  for (std::size_t d = 0; d < dimensions; ++d) shift_.push_back(seed == 0 ? 0 : countedRandom(seed, kShift, d));
}

void SobolSequence::point(std::uint64_t index, std::span<double> point) const {
  if (index >> kBits != 0) throw std::invalid_argument("SobolSequence: index must be below 2^40");
  const std::size_t dimensions = shift_.size();
  const std::uint64_t gray = index ^ (index >> 1);
  for (std::size_t d = 0; d < dimensions; ++d) {
    std::uint64_t bits = shift_[d];
    for (std::uint64_t rest = gray; rest != 0; rest &= rest - 1) {
      bits ^= directions_[static_cast<std::size_t>(std::countr_zero(rest)) * dimensions + d];
    }
    point[d] = unitInterval(bits);
  }
}

}  // namespace vehicle
