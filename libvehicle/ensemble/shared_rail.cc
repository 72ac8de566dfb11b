#include "libvehicle/ensemble/shared_rail.h"

#include <algorithm>

namespace vehicle::ensemble {
namespace {

constexpr std::size_t kRowWidth = 8, kSampleWidth = 12;
constexpr int kBlocksPerPiece = 16;  // of kStepsPerBlock steps: 256 KiB of rows, a quarter of a second-level cache
constexpr std::size_t kRowsPerBlock = 2 * static_cast<std::size_t>(kStepsPerBlock) + 1;

}  // namespace

SharedRail::SharedRail(const Input& input, const Schedule& schedule, FixedStep step, int first_counted,
                       bool reads_rail)
    : input_(input),
      schedule_(schedule),
      step_(step),
      first_counted_(first_counted),
      reads_rail_(reads_rail),
      rows_(kBlocksPerPiece * kRowsPerBlock * kRowWidth),
      // A block ends as many stretches as it has steps at most; the sample at the start comes on top.
      samples_((kBlocksPerPiece * static_cast<std::size_t>(kStepsPerBlock) + 1) * kSampleWidth) {}

bool SharedRail::next() {
  legs_.clear();
  rows_used_ = samples_used_ = 0;
  if (!begun_) {
    begun_ = true;
    const Stretch& start = schedule_.stretches().front();
    addSample(0, start.segment, start.begin, true);
  }
  for (int block = 0; block < kBlocksPerPiece && stretch_ < schedule_.stretches().size(); ++block) addBlock();
  return !legs_.empty();
}

void SharedRail::addSample(int number, int segment, double t, bool alone) {
  double* sample = samples_.data() + samples_used_;
  samples_used_ += kSampleWidth;
  const bool counts = number >= first_counted_;
  if (counts && reads_rail_) input_.evaluate(segment, t, {sample, kSampleWidth});
  if (alone) legs_.push_back({});
  legs_.back().sample = sample;
  legs_.back().number = number;
  legs_.back().counted = counts ? number - first_counted_ : -1;
}

// The next block of the grid, cut where stretches end.
void SharedRail::addBlock() {
  const std::vector<Stretch>& stretches = schedule_.stretches();
  if (done_ == 0) {
    first_ = stretch_;
    grid_ = stepGridAt(schedule_, stretch_, step_);
    left_ = grid_.steps;
  }
  const Stretch& begin = stretches[first_];
  const int total = grid_.steps * static_cast<int>(grid_.count);
  const int block_end = std::min(done_ + kStepsPerBlock, total);
  const auto values = 2 * static_cast<std::size_t>(block_end - done_) + 1;
  const double* row = rows_.data() + rows_used_;
  input_.sweep(begin.segment, begin.begin, 0.5 * grid_.h, 2 * done_, static_cast<int>(values),
               {rows_.data() + rows_used_, values * kRowWidth});
  rows_used_ += values * kRowWidth;
  while (done_ < block_end) {
    const int steps = std::min(left_, block_end - done_);
    legs_.push_back({.rail = row, .sample = nullptr, .h = grid_.h, .steps = steps});
    done_ += steps;
    left_ -= steps;
    steps_ += steps;
    row += 2 * static_cast<std::size_t>(steps) * kRowWidth;
    if (left_ > 0) break;  // the block ends inside a stretch
    const Stretch& stretch = stretches[stretch_];
    if (stretch.sample >= 0) addSample(stretch.sample, stretch.next, stretch.end, false);
    ++stretch_;
    left_ = grid_.steps;
  }
  if (done_ == total) done_ = 0;
}

}  // namespace vehicle::ensemble
