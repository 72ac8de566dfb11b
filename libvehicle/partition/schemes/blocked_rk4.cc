#include "libvehicle/partition/schemes/blocked_rk4.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

#include "libvehicle/integrate/drive.h"
#include "libvehicle/integrate/failure.h"
#include "libvehicle/integrate/rk4_stages.h"
#include "libvehicle/partition/map/cut_order.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// What the channels of a run ask beyond those already read.
ChannelRun beyond(ChannelRun wanted, int& read) {
  if (wanted.last <= read) return {};
  const ChannelRun more{std::max(read, wanted.first), wanted.last};
  read = wanted.last;
  return more;
}

}  // namespace

BlockedRk4::BlockedRk4(const EquationSet& set, const EquationGraph& graph, const Input& input, EquationRun target,
                       int block)
    : set_(set), input_(input) {
  if (target.first < 0 || target.size() < 1 || target.last > graph.size() || block < 1) {
    throw std::invalid_argument("blocked rk4: equations " + std::to_string(target.first) + " to " +
                                std::to_string(target.last) + " of " + std::to_string(graph.size()) + " in blocks of " +
                                std::to_string(block) + "; must be one equation or more in blocks of at least one");
  }
  plan(graph, target, block);
  x_.resize(at(2 * held_.size()));
  if (isSwept(input)) {
    swept_.emplace(input);
    channels_ = {0, set.channels()};
    return;
  }
  for (auto* row : {&begin_, &middle_, &end_, &part_}) row->resize(at(2 * channels_.size()));
}

void BlockedRk4::plan(const EquationGraph& graph, EquationRun target, int block) {
  EquationRun stage[4];  // equations of which each stage is taken
  stage[3] = target;
  for (int s = 2; s >= 0; --s) stage[s] = graph.reach(stage[s + 1]);
  first_stage_ = stage[0];
  held_ = graph.reach(first_stage_);
  channels_ = graph.channels(first_stage_);

  int end[4];
  for (int s = 0; s < 4; ++s) end[s] = stage[s].first;
  int middle_read = graph.channels(stage[1]).first;
  int end_read = channels_.first;
  int reached = held_.first;
  int longest = 0;
  while (end[3] < stage[3].last) {
    Block now;
    for (int s = 0; s < 4; ++s) {
      now.stage[s].first = end[s];
      if (s == 0) {
        end[0] = std::min(end[0] + block, stage[0].last);
      } else {
        const bool complete = end[s - 1] == stage[s - 1].last;
        while (end[s] < stage[s].last && (complete || graph.highest(end[s]) < end[s - 1])) ++end[s];
      }
      now.stage[s].last = end[s];
      longest = std::max(longest, now.stage[s].size());
    }
    // Rows are read once, as far as this block's stages ask; equations of any order may ask for channels of any.
    const auto wanted = [&](EquationRun run, int from) {
      ChannelRun hull = graph.channels(run);
      hull.first = std::min(hull.first, from);
      return hull;
    };
    now.middle = beyond(wanted({stage[1].first, end[1]}, middle_read), middle_read);
    const int end_before = end_read;
    now.end = beyond(wanted({stage[3].first, end[3]}, end_read), end_read);
    if (end[3] == stage[3].last) now.end = {end_before, channels_.last};
    reached = std::max(reached, graph.reach(now.stage[0]).last);
    reach_.push_back(reached);
    blocks_.push_back(now);
  }
  // What stays in the window: whatever stages 2 to 4 of this block or a later one still read.
  int keep = first_stage_.last;
  for (std::size_t b = blocks_.size(); b-- > 0;) {
    for (int s = 1; s < 4; ++s) {
      const EquationRun run = blocks_[b].stage[s];
      keep = std::min({keep, run.first, graph.reach(run).first});
    }
    keep = std::max(std::min(keep, blocks_[b].stage[0].first), first_stage_.first);
    blocks_[b].keep = keep;
    capacity_ = std::max(capacity_, blocks_[b].stage[0].last - keep);
  }
  // Twice the room: the window is then moved once in a few blocks and not in each.
  capacity_ = std::min(2 * capacity_, first_stage_.size());
  slope_.resize(at(2 * longest));
  for (auto* values : {&sum_, &second_, &third_, &fourth_}) values->resize(at(2 * capacity_));
}

int BlockedRk4::firstBlockReading(int equation) const {
  // Blocks read upwards; an equation below all of them is read by the first.
  const auto found = std::find_if(reach_.begin(), reach_.end(), [&](int last) { return equation < last; });
  return static_cast<int>(found - reach_.begin());
}

void BlockedRk4::enter(const StepBlock& steps) {
  if (swept_) {
    swept_->sweep(steps);
    return;
  }
  steps.prepare(input_, clock_);
  readRow(0, channels_, begin_);
}

void BlockedRk4::readRow(int sample, ChannelRun channels, std::vector<double>& row) {
  const int count = channels.size();
  if (swept_ || count <= 0) return;
  double* heights = row.data() + (channels.first - channels_.first);
  if (count == channels_.size()) {
    input_.readRow(clock_, sample, channels.first, channels.last, heights);
    return;
  }
  input_.readRow(clock_, sample, channels.first, channels.last, part_.data());
  std::copy_n(part_.data(), count, heights);
  std::copy_n(part_.data() + count, count, heights + channels_.size());
}

const double* BlockedRk4::row(int which, int k) const {
  if (swept_) return swept_->row(2 * k + which);
  return (which == 0 ? begin_ : which == 1 ? middle_ : end_).data();
}

void BlockedRk4::prepare(int k) { readRow(2 * k + 1, blocks_.front().middle, middle_); }

void BlockedRk4::slideTo(const Block& block) {
  if (&block == &blocks_.front()) {
    base_ = first_stage_.first;
    filled_ = base_;
  }
  if (block.stage[0].last - base_ > capacity_) {
    const auto from = 2 * (block.keep - base_);
    const auto count = 2 * (filled_ - block.keep);
    for (auto* values : {&sum_, &second_, &third_, &fourth_}) {
      std::copy_n(values->data() + from, count, values->data());
    }
    base_ = block.keep;
  }
  filled_ = block.stage[0].last;
}

void BlockedRk4::evaluate(EquationRun run, const double* x, int x_first, const double* row) {
  set_.derivative({.first = run.first, .last = run.last, .x = x, .x_first = x_first, .u = row,
                   .u_first = channels_.first, .u_count = channels_.size(), .dx = slope_.data(),
                   .dx_first = run.first});
}

void BlockedRk4::advance(double h, int k, int number) {
  const Block& block = blocks_[at(number)];
  slideTo(block);
  const auto inWindow = [&](std::vector<double>& values, EquationRun run) {
    return values.data() + 2 * (run.first - base_);
  };
  const EquationRun first = block.stage[0];
  evaluate(first, x_.data(), held_.first, row(0, k));
  afterFirstStage(h, x(first.first), slope_.data(), inWindow(sum_, first), inWindow(second_, first),
                  2 * first.size());
  if (number > 0) readRow(2 * k + 1, block.middle, middle_);
  const EquationRun second = block.stage[1];
  if (second.size() > 0) {
    evaluate(second, second_.data(), base_, row(1, k));
    afterMiddleStage<1>(h, x(second.first), slope_.data(), inWindow(sum_, second), inWindow(third_, second),
                        2 * second.size());
  }
  const EquationRun third = block.stage[2];
  if (third.size() > 0) {
    evaluate(third, third_.data(), base_, row(1, k));
    afterMiddleStage<2>(h, x(third.first), slope_.data(), inWindow(sum_, third), inWindow(fourth_, third),
                        2 * third.size());
  }
  readRow(2 * k + 2, block.end, end_);
  const EquationRun fourth = block.stage[3];
  if (fourth.size() > 0) {
    evaluate(fourth, fourth_.data(), base_, row(2, k));
    afterLastStage(h, slope_.data(), inWindow(sum_, fourth), x(fourth.first), 2 * fourth.size());
  }
}

namespace {

/// The whole system, on the calling thread.
class BlockedSteps final : public DrivenByType<BlockedSteps> {
 public:
  BlockedSteps(const RunProblem& problem, FixedStep step)
      : cut_(problem),
        graph_(cut_.set()),
        rk4_(cut_.set(), graph_, cut_.input(), {0, graph_.size()}),
        cursor_(step, rk4_.stepsOfBlock()),
        x_(problem.x0.size()) {}

  void restart(const Interval&, std::span<const double> x) override {
    checkStart(kName, x, static_cast<int>(x_.size()));
    std::copy(x.begin(), x.end(), x_.begin());
    for (std::size_t i = 0; i < x_.size(); ++i) rk4_.x()[i] = x_[at(cut_.set().stateOrder()[i])];
    cursor_.restart();
  }

  void advance(const Interval& interval) override {
    const auto check = [&](double reached) {
      for (std::size_t i = 0; i < x_.size(); ++i) x_[at(cut_.set().stateOrder()[i])] = rk4_.x()[i];
      requireFinite(kName, reached, x_);
      return true;
    };
    cursor_.advance(
        interval, [&](const StepBlock& steps) { rk4_.enter(steps); },
        [&](double h, int k) {
          rk4_.prepare(k);
          rk4_.step(h, k, [](int) {});
        },
        check);
    check(cursor_.reached());
  }

  [[nodiscard]] std::span<const double> state() const override { return x_; }
  [[nodiscard]] Statistics statistics() const override {
    return {.steps = cursor_.steps(), .evaluations = 4 * cursor_.steps()};
  }

 private:
  static constexpr const char* kName = "rk4";

  CutRun cut_;
  EquationGraph graph_;
  BlockedRk4 rk4_;
  StepCursor cursor_;
  std::vector<double> x_;  // in the system's order
};

}  // namespace

std::unique_ptr<Integrator> makeBlockedRk4(const RunProblem& problem, FixedStep step) {
  return std::make_unique<BlockedSteps>(problem, step);
}

}  // namespace vehicle
