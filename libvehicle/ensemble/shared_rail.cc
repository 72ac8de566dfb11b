#include "libvehicle/ensemble/shared_rail.h"

#include <algorithm>

namespace vehicle::ensemble {
namespace {

constexpr std::size_t kRowWidth = 8, kSampleWidth = 12;
constexpr int kBlocksPerPiece = 16;  // of kStepsPerBlock steps: 256 KiB of rows, a quarter of a second-level cache
constexpr std::size_t kRowsPerBlock = 2 * static_cast<std::size_t>(kStepsPerBlock) + 1;

}  // namespace

SharedRail::SharedRail(const Input& input, const Schedule& schedule, FixedStep step, int first_stored)
    : input_(input),
      schedule_(schedule),
      step_(step),
      first_stored_(first_stored),
      interval_(schedule.intervals().begin()),
      rows_(kBlocksPerPiece * kRowsPerBlock * kRowWidth),
      // A block ends as many intervals as it has steps at most, each perhaps with two limits; the start comes on top.
      samples_((2 * kBlocksPerPiece * static_cast<std::size_t>(kStepsPerBlock) + 2) * kSampleWidth) {}

bool SharedRail::next() {
  legs_.clear();
  rows_used_ = samples_used_ = 0;
  const Schedule::Iterator end = schedule_.intervals().end();
  if (!begun_) {
    begun_ = true;
    const Interval start = *interval_;
    beginPart(start.segment, start.begin, 0);
  }
  for (int block = 0; block < kBlocksPerPiece && !(interval_ == end); ++block) addBlock();
  return !legs_.empty();
}

// A sample at the end of the last leg.
void SharedRail::addSample(int segment, double t, const Look<double>& look) {
  double* sample = samples_.data() + samples_used_;
  samples_used_ += kSampleWidth;
  input_.evaluate(segment, t, {sample, kSampleWidth});
  legs_.back().sample = sample;
  legs_.back().number = number_;
  legs_.back().look = look;
}

// The part of the interval at hand: its first sample, the right-hand limit where the rail breaks.
void SharedRail::beginPart(int segment, double t, int regular) {
  part_.emplace(schedule_, interval_.part());
  legs_.push_back({});
  addSample(segment, t, part_->at(0));
  if (regular >= first_stored_) legs_.back().stored = regular - first_stored_;
}

void SharedRail::endInterval(const Interval& interval) {
  const Schedule::Part& part = interval_.part();
  const std::size_t own = interval_.index() - part.first_interval + 1;
  ++number_;
  addSample(interval.segment, interval.end, part_->at(own));
  ++interval_;
  const bool ends_part = own == part.count;
  if (ends_part && !(interval_ == schedule_.intervals().end())) {
    beginPart(interval.next, interval.end, interval.regular);
  } else if (interval.regular >= first_stored_) {
    legs_.back().stored = interval.regular - first_stored_;
  }
}

// The next block of the grid, cut where intervals end.
void SharedRail::addBlock() {
  if (done_ == 0) {
    grid_ = stepGridFrom(*interval_, step_);
    left_ = grid_.steps;
  }
  const int block_end = std::min(done_ + kStepsPerBlock, grid_.total());
  const StepBlock block{grid_.segment, grid_.begin, grid_.h, done_, block_end};
  const std::size_t values = static_cast<std::size_t>(block.rows()) * kRowWidth;
  const double* row = rows_.data() + rows_used_;
  block.sweep(input_, {rows_.data() + rows_used_, values});
  rows_used_ += values;
  while (done_ < block_end) {
    const int steps = std::min(left_, block_end - done_);
    SharedLeg leg;
    leg.rail = row;
    leg.h = grid_.h;
    leg.steps = steps;
    legs_.push_back(leg);
    done_ += steps;
    left_ -= steps;
    steps_ += steps;
    row += 2 * static_cast<std::size_t>(steps) * kRowWidth;
    if (left_ > 0) break;  // the block ends inside an interval
    endInterval(*interval_);
    left_ = grid_.steps;
  }
  if (done_ == grid_.total()) done_ = 0;
}

}  // namespace vehicle::ensemble
