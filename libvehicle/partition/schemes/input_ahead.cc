#include "libvehicle/partition/schemes/input_ahead.h"

#include <algorithm>

namespace vehicle {
InputParcels::InputParcels(const Schedule& schedule, FixedStep step) {
  const std::size_t intervals = schedule.intervals().size();
  int room = 0;  // steps that still fit into the last group
  int rows = 0;  // of the last group
  long done = 0;  // steps
  for (std::size_t first = 0; first < intervals;) {
    const StepGrid grid = stepGridFrom(schedule.intervals()[first], step);
    const int steps = grid.total();
    grids_.push_back({grid.segment, grid.begin, grid.h, steps});
    if (steps > room) {
      groups_.push_back({count_, grids_.size() - 1, grids_.size(), done, done + steps});
      count_ += (steps + kStepsPerBlock - 1) / kStepsPerBlock;
      room = std::max(0, kStepsPerBlock - steps);
      rows = 2 * std::min(steps, kStepsPerBlock) + 1;
    } else {
      groups_.back().last_grid = grids_.size();
      groups_.back().last_step += steps;
      room -= steps;
      rows += 2 * steps + 1;
    }
    most_rows_ = std::max(most_rows_, rows);
    done += steps;
    first += static_cast<std::size_t>(grid.count);
  }
}

const InputParcels::Group& InputParcels::groupOf(long parcel) const {
  const auto after = std::upper_bound(groups_.begin(), groups_.end(), parcel,
                                      [](long p, const Group& group) { return p < group.first_parcel; });
  return *(after - 1);
}

InputParcels::Steps InputParcels::stepsOf(long parcel) const {
  const Group& group = groupOf(parcel);
  const long first = group.first_step + (parcel - group.first_parcel) * kStepsPerBlock;
  return {first, std::min(first + kStepsPerBlock, group.last_step)};
}

void InputParcels::read(long parcel, std::vector<StepBlock>& blocks) const {
  const Group& group = groupOf(parcel);
  blocks.clear();
  const int first = static_cast<int>(parcel - group.first_parcel) * kStepsPerBlock;
  for (std::size_t g = group.first_grid; g < group.last_grid; ++g) {
    const Grid& grid = grids_[g];
    blocks.push_back({grid.segment, grid.begin, grid.h, first, std::min(first + kStepsPerBlock, grid.steps)});
  }
}

InputAhead::InputAhead(const Schedule& schedule, FixedStep step, int width, const BlockRows& rows)
    : parcels_(schedule, step), width_(static_cast<std::size_t>(width)), rows_(rows),
      count_(std::clamp<long>(static_cast<long>(kMostBytes / (8 * mostValues())), 2, kMostSlots)),
      slots_(static_cast<std::size_t>(count_)) {
  const std::size_t most = mostValues();
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    slots_[s].rows.resize(most);
    slots_[s].state.store(word(static_cast<long>(s), kOpen), std::memory_order_relaxed);
  }
  own_.resize(most);
}

void InputAhead::compute(long parcel, std::vector<StepBlock>& blocks, double* u) const {
  parcels_.read(parcel, blocks);
  for (const StepBlock& block : blocks) {
    rows_(block, u);
    u += static_cast<std::size_t>(block.rows()) * width_;
  }
}

bool InputAhead::computeIfOpen(Member& me, long parcel, std::vector<StepBlock>& blocks) {
  Slot& slot = slotOf(parcel);
  long open = word(parcel, kOpen);
  // Look before the exchange: one that fails takes the line away from its owner all the same.
  if (slot.state.load(std::memory_order_relaxed) != open) return false;
  if (!slot.state.compare_exchange_strong(open, word(parcel, kClaimed), std::memory_order_acquire,
                                          std::memory_order_relaxed)) {
    return false;
  }
  slot.owner.store(me.number(), std::memory_order_relaxed);
  me.injectDelay(parcel);
  compute(parcel, blocks, slot.rows.data());
  slot.state.store(word(parcel, kReady), std::memory_order_release);
  me.ring();
  return true;
}

void InputAhead::help(Member& me) {
  std::vector<StepBlock> blocks;
  for (long parcel = 0;; ++parcel) {
    parcel = std::max(parcel, done_.load(std::memory_order_acquire));
    if (parcel >= parcels_.count()) return;
    me.wait([&] { return done_.load(std::memory_order_acquire) > parcel - count_; }, 0);
    const InputParcels::Steps steps = parcels_.stepsOf(parcel);
    me.beginSteps(steps.first, steps.last);
    computeIfOpen(me, parcel, blocks);
    me.endStep(steps.first);
  }
}

bool InputAhead::isReadyInTime(Member& me, Slot& slot) {
  const long ready = word(parcel_, kReady);
  const auto isReady = [&] { return slot.state.load(std::memory_order_acquire) == ready; };
  for (ahead_ = std::max(ahead_, parcel_ + 1); !isReady();) {
    const long end = std::min(parcel_ + count_, parcels_.count());
    while (ahead_ < end && !computeIfOpen(me, ahead_, scratch_)) ++ahead_;
    if (ahead_ < end) {
      ++counts_.shared;
      ++ahead_;
      continue;
    }
    using Clock = std::chrono::steady_clock;
    const Clock::time_point deadline = Clock::now() + kPatience;
    me.wait([&] { return isReady() || Clock::now() >= deadline; }, slot.owner.load(std::memory_order_relaxed));
    return isReady();
  }
  return true;
}

const double* InputAhead::acquire(Member& me) {
  Slot& slot = slotOf(parcel_);
  long seen = slot.state.load(std::memory_order_acquire);
  // Open, for this parcel or for one that was passed while the slot was out of service: nobody else computes it.
  if (seen % kPhases == kOpen &&
      slot.state.compare_exchange_strong(seen, word(parcel_ + count_, kOpen), std::memory_order_acq_rel,
                                         std::memory_order_acquire)) {
    from_slot_ = false;
  } else {
    from_slot_ = seen == word(parcel_, kReady) || (seen == word(parcel_, kClaimed) && isReadyInTime(me, slot));
    if (seen == word(parcel_, kClaimed) && !from_slot_) ++counts_.redone;
    // Ready for a parcel that was passed: its thread came back at last.
    if (!from_slot_ && seen % kPhases == kReady) {
      slot.state.store(word(parcel_ + count_, kOpen), std::memory_order_release);
    }
  }
  if (from_slot_) {
    ++counts_.taken;
    parcels_.read(parcel_, blocks_);
    return slot.rows.data();
  }
  ++counts_.own;
  compute(parcel_, blocks_, own_.data());
  return own_.data();
}

void InputAhead::release(Member& me) {
  if (from_slot_) slotOf(parcel_).state.store(word(parcel_ + count_, kOpen), std::memory_order_release);
  done_.store(parcel_ + 1, std::memory_order_release);
  me.ring();
}

const double* InputAhead::enter(Member& me, const StepBlock& block) {
  if (block_ == blocks_.size()) {
    if (parcel_ >= 0) release(me);
    ++parcel_;
    me.injectDelay(parcel_);
    next_ = acquire(me);
    block_ = 0;
  }
  ++block_;
  const double* rows = next_;
  next_ += static_cast<std::size_t>(block.rows()) * width_;
  return rows;
}

}  // namespace vehicle
