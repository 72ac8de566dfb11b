#include "libvehicle/track/sampled_rail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace vehicle {

struct SampledRail::Block {
  std::int64_t number = 0;
  // Of its samples, the first of the next block included. In one piece: blocks come and go as long as a run lasts.
  std::array<double, kBlock + 1> height;  // [m]
  std::array<double, kBlock + 1> rise;    // [m] slope times spacing
};

namespace {

/// Most samples that a block is made from.
constexpr std::size_t kMostRead = SampledRail::kBlock + 2 * SampledRail::kReach + 1;
// On the stack, so that memory holds blocks alone, all of one size.
using Window = std::array<double, kMostRead>;

/// Rise at the first of equally spaced values: the derivative of the polynomial through at most five of them.
/// @param step  1 for the first of `values`, -1 where they run backwards from `at`
double oneSidedRise(std::span<const double> values, std::size_t at, int step) {
  const int points = static_cast<int>(std::min<std::size_t>(values.size(), 5));
  const auto value = [&](int j) { return values[at + static_cast<std::size_t>(step * j)]; };
  double rise = 0.0, harmonic = 0.0, binomial = 1.0;
  for (int j = 1; j < points; ++j) {
    binomial = binomial * (points - j) / j;
    rise += (j % 2 == 1 ? 1.0 : -1.0) / j * binomial * value(j);
    harmonic += 1.0 / j;
  }
  return step * (rise - harmonic * value(0));
}

/// Rises m of the spline at all values z: m_{k-1} + 4 m_k + m_{k+1} = 3 (z_{k+1} - z_{k-1}) between given ends, by
/// elimination.
void findRises(std::span<const double> z, Window& rise) {
  const std::size_t last = z.size() - 1;
  Window over;  // what an unknown takes of the next
  over[0] = 0.0;
  rise[0] = oneSidedRise(z, 0, 1);
  rise[last] = oneSidedRise(z, last, -1);
  for (std::size_t k = 1; k < last; ++k) {
    const double pivot = 1.0 / (4.0 - over[k - 1]);
    over[k] = pivot;
    rise[k] = (3.0 * (z[k + 1] - z[k - 1]) - rise[k - 1]) * pivot;
  }
  for (std::size_t k = last - 1; k > 0; --k) rise[k] -= over[k] * rise[k + 1];
}

}  // namespace

SampledRail::SampledRail(std::shared_ptr<RailSamples> samples, SampleGridOverDistance grid)
    : samples_(std::move(samples)), grid_(grid), intervals_(samples_->count() - 1), slots_(kSlots) {
  std::ostringstream message;
  if (intervals_ < 1) {
    message << "sampled rail: " << intervals_ + 1 << " samples, must be 2 or more";
  } else if (!(grid.spacing > 0.0 && std::isfinite(grid.spacing) && std::isfinite(grid.begin))) {
    message << "sampled rail: begin = " << grid.begin << " m, spacing = " << grid.spacing
            << " m; must be finite, spacing > 0";
  }
  if (!message.str().empty()) throw std::invalid_argument(message.str());
}

SampledRail::~SampledRail() = default;

double SampledRail::end() const { return grid_.begin + static_cast<double>(intervals_) * grid_.spacing; }

double SampledRail::fastestWave() const { return 0.5 * std::numbers::pi / grid_.spacing; }

SampledRail::Held SampledRail::makeBlock(std::int64_t number) const {
  const std::int64_t first = number * kBlock;
  const std::int64_t last = std::min(first + kBlock, intervals_);
  const std::int64_t from = std::max<std::int64_t>(0, first - kReach);
  const std::int64_t to = std::min(intervals_, last + kReach);
  Window read, rises;
  const std::span<double> heights = std::span(read).first(static_cast<std::size_t>(to - from + 1));
  {
    const std::lock_guard one_reader(reading_);
    samples_->read(from, heights);
  }
  const auto bad = std::find_if_not(heights.begin(), heights.end(), [](double z) { return std::isfinite(z); });
  if (bad != heights.end()) {
    std::ostringstream message;
    message << "sampled rail: the height at s = "
            << grid_.begin + static_cast<double>(from + (bad - heights.begin())) * grid_.spacing << " m is " << *bad
            << ", must be finite";
    throw std::runtime_error(message.str());
  }
  findRises(heights, rises);
  auto block = std::make_shared<Block>();
  block->number = number;
  std::copy(heights.begin() + (first - from), heights.begin() + (last - from + 1), block->height.begin());
  std::copy(rises.begin() + (first - from), rises.begin() + (last - from + 1), block->rise.begin());
  return block;
}

SampledRail::Held SampledRail::blockOf(std::int64_t number) const {
  Slot& slot = slots_[static_cast<std::size_t>(number) % kSlots];
  {
    const std::lock_guard one_by_one(slot.changing);
    if (slot.block && slot.block->number == number) return slot.block;
  }
  Held made = makeBlock(number);
  const std::lock_guard one_by_one(slot.changing);
  slot.block = made;
  return made;
}

RailPoint SampledRail::at(double s, Held& held) const {
  const double place = (s - grid_.begin) / grid_.spacing;
  const double nearest = std::clamp(std::floor(place), 0.0, static_cast<double>(intervals_ - 1));
  const auto interval = static_cast<std::int64_t>(nearest);
  const std::int64_t number = interval / kBlock;
  if (!held || held->number != number) held = blockOf(number);
  const auto k = static_cast<std::size_t>(interval - number * kBlock);
  const double share = place - nearest;  // 0..1
  const double d = grid_.spacing;
  const double rise = held->height[k + 1] - held->height[k];
  const double square = 3.0 * rise - 2.0 * held->rise[k] - held->rise[k + 1];
  const double cube = held->rise[k] + held->rise[k + 1] - 2.0 * rise;
  return {held->height[k] + share * (held->rise[k] + share * (square + share * cube)),
          (held->rise[k] + share * (2.0 * square + 3.0 * share * cube)) / d,
          (2.0 * square + 6.0 * share * cube) / (d * d)};
}

}  // namespace vehicle
