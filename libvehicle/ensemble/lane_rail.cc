#include "libvehicle/ensemble/lane_rail.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libvehicle/integrate/fixed_step_run.h"

namespace vehicle::ensemble {
namespace {

// Steps after which sine and cosine are computed anew: in between each turn rounds, which adds up to about the
// square root of 1024 roundings.
constexpr int kStepsPerSeed = 512;

// Rows of LaneRail::time.
constexpr std::size_t kAnchor = 0, kHalf = 1, kCount = 2, kIncrement = 3;

int stretchesPerSeed(int steps) { return (kStepsPerSeed + steps - 1) / steps; }

}  // namespace

LanePlan::LanePlan(const Input& rail, const Schedule& schedule, FixedStep step)
    : input(&rail), samples(schedule.samples()), output_step(schedule.outputStep()) {
  const std::vector<Stretch>& stretches = schedule.stretches();
  const int whole_steps = stepsOf(output_step, step);
  for (std::size_t first = 0; first < stretches.size();) {
    const StepGrid grid = stepGridAt(schedule, first, step);
    const Stretch& begin = stretches[first];
    const Stretch& end = stretches[first + grid.count - 1];
    Piece piece{begin.segment, end.next, begin.begin, grid.h, grid.steps, static_cast<int>(grid.count), false,
                end.sample >= 0};
    piece.whole = piece.sample && grid.steps == whole_steps && grid.h == output_step / whole_steps;
    pieces.push_back(piece);
    first += grid.count;
  }
}

LaneRun::LaneRun(std::span<const LanePlan* const> plans, std::span<const FlatParameters* const> vehicles)
    : lanes_(plans.size()) {
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    lanes_[i].plan = plans[i];
    lanes_[i].vehicle = vehicles[i];
    for (int k = 0; k < plans[i]->input->segments(); ++k) {
      const InputSegment& segment = plans[i]->input->segment(k);
      frequencies_ = std::max(frequencies_, segment.angular_frequency.size());
      rail_.polynomial = rail_.polynomial || std::any_of(segment.polynomial.begin(), segment.polynomial.end(),
                                                         [](double value) { return value != 0.0; });
    }
  }
  const std::size_t width = lanes_.size();
  oscillator_ = AlignedDoubles(8 * frequencies_ * width);
  wheel_ = AlignedDoubles(9 * frequencies_ * width);
  force_polynomial_ = AlignedDoubles(8 * width);
  wheel_polynomial_ = AlignedDoubles(16 * width);
  half_step_ = AlignedDoubles(width);
  time_ = AlignedDoubles(4 * width);
  last_sample_ = AlignedDoubles(width);
  rail_.frequencies = static_cast<int>(frequencies_);
  rail_.oscillator = oscillator_.data();
  rail_.wheel = wheel_.data();
  rail_.force_polynomial = force_polynomial_.data();
  rail_.wheel_polynomial = wheel_polynomial_.data();
  rail_.half_step = half_step_.data();
  rail_.time = time_.data();
  rail_.last_sample = last_sample_.data();
  for (std::size_t i = 0; i < width; ++i) {
    lanes_[i].turn.resize(2 * frequencies_);
    at(last_sample_, 0, i) = lanes_[i].plan->samples - 1;
    enter(i, true);
  }
}

void LaneRun::loadSegment(std::size_t lane, int index) {
  const InputSegment& segment = lanes_[lane].plan->input->segment(index);
  const FlatParameters& v = *lanes_[lane].vehicle;
  const std::size_t F = segment.angular_frequency.size();
  for (std::size_t f = 0; f < frequencies_; ++f) {
    const double w = f < F ? segment.angular_frequency[f] : 0.0;
    double force[4] = {};  // front: of cos, of sin; rear
    for (std::size_t j = 0; j < 4; ++j) {
      const double cosine = f < F ? segment.cosine[j * F + f] : 0.0;
      const double sine = f < F ? segment.sine[j * F + f] : 0.0;
      at(wheel_, 9 * f + 2 * j, lane) = cosine;
      at(wheel_, 9 * f + 2 * j + 1, lane) = sine;
      force[2 * (j / 2)] += v.cp[j] * cosine + v.bp[j] * w * sine;
      force[2 * (j / 2) + 1] += v.cp[j] * sine - v.bp[j] * w * cosine;
    }
    at(wheel_, 9 * f + 8, lane) = w;
    for (std::size_t i = 0; i < 4; ++i) at(oscillator_, 8 * f + 4 + i, lane) = force[i];
  }
  double force[8] = {};
  for (std::size_t j = 0; j < 4; ++j) {
    const double* p = segment.polynomial.data() + 4 * j;
    double* bogie = force + 4 * (j / 2);
    for (std::size_t power = 0; power < 4; ++power) {
      at(wheel_polynomial_, 4 * j + power, lane) = p[power];
      bogie[power] += v.cp[j] * p[power];
      if (power < 3) bogie[power] += v.bp[j] * static_cast<double>(power + 1) * p[power + 1];
    }
  }
  for (std::size_t i = 0; i < 8; ++i) at(force_polynomial_, i, lane) = force[i];
}

void LaneRun::seed(std::size_t lane, double t) {
  const LanePlan::Piece& piece = lanes_[lane].now();
  const InputSegment& segment = lanes_[lane].plan->input->segment(piece.segment);
  const double s = t - segment.begin;
  for (std::size_t f = 0; f < frequencies_; ++f) {
    const double angle = f < segment.angular_frequency.size() ? segment.angular_frequency[f] * s : 0.0;
    at(oscillator_, 8 * f, lane) = std::cos(angle);
    at(oscillator_, 8 * f + 1, lane) = std::sin(angle);
  }
  at(time_, kAnchor, lane) = s;
  at(time_, kHalf, lane) = 0.5 * piece.h;
  at(time_, kCount, lane) = 0.0;
}

// The piece that the lane has arrived at.
void LaneRun::enter(std::size_t index, bool new_segment) {
  Lane& lane = lanes_[index];
  lane.stretch = 0;
  if (lane.over()) return;
  const LanePlan::Piece& piece = lane.now();
  if (new_segment) loadSegment(index, piece.segment);
  const InputSegment& segment = lane.plan->input->segment(piece.segment);
  for (std::size_t f = 0; f < frequencies_; ++f) {
    const double quarter = f < segment.angular_frequency.size() ? 0.25 * segment.angular_frequency[f] * piece.h : 0.0;
    lane.turn[2 * f] = -2.0 * std::sin(quarter) * std::sin(quarter);
    lane.turn[2 * f + 1] = std::sin(2.0 * quarter);
  }
  seed(index, piece.begin);
}

void LaneRun::setMoving(std::size_t index, bool moving) {
  const Lane& lane = lanes_[index];
  at(half_step_, 0, index) = moving ? 0.5 * lane.now().h : 0.0;
  at(time_, kIncrement, index) = moving ? 1.0 : 0.0;
  for (std::size_t f = 0; f < frequencies_; ++f) {
    at(oscillator_, 8 * f + 2, index) = moving ? lane.turn[2 * f] : 0.0;
    at(oscillator_, 8 * f + 3, index) = moving ? lane.turn[2 * f + 1] : 0.0;
  }
}

// Whole output steps that all lanes can make together; 0: one of them meets a kink on the way to the next sample.
int LaneRun::commonIntervals() const {
  int most = std::numeric_limits<int>::max();
  for (const Lane& lane : lanes_) {
    if (lane.over()) continue;
    if (!lane.now().whole) return 0;
    const int to_seed = stretchesPerSeed(lane.now().steps);
    most = std::min({most, lane.now().stretches - lane.stretch, to_seed - lane.stretch % to_seed});
  }
  return most;
}

// Whether a lane is at the end of its piece and of its segment after so many stretches.
bool LaneRun::changesSegment(const Lane& lane, int intervals) const {
  return !lane.over() && lane.stretch + intervals == lane.now().stretches && lane.now().next != lane.now().segment;
}

void LaneRun::call(const LaneLeg& leg) {
  LaneLeg numbered = leg;
  numbered.number = number_;
  numbered.counted = number_ - first_counted_;
  kernels_->runLanes(*block_, *choice_, rail_, numbered);
  if (leg.sample) number_ += leg.intervals;
}

void LaneRun::walkUniform(int intervals) {
  int steps = 0;
  bool kink = false;
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    if (!lanes_[i].over()) steps = lanes_[i].now().steps;
    setMoving(i, !lanes_[i].over());
    kink = kink || changesSegment(lanes_[i], intervals);
  }
  if (!kink) {
    call({.steps = steps, .intervals = intervals});
  } else {
    // The sample on a kink shows the segment that begins there, so that lane changes before it.
    if (intervals > 1) call({.steps = steps, .intervals = intervals - 1});
    call({.steps = steps, .intervals = 1, .sample = false});
  }
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    Lane& lane = lanes_[i];
    if (lane.over()) continue;
    const bool changes = changesSegment(lane, intervals);
    lane.stretch += intervals;
    if (!changes) continue;
    ++lane.piece;
    enter(i, true);
  }
  if (kink) call({.steps = 0, .intervals = 1});
}

void LaneRun::walkMixed() {
  for (Lane& lane : lanes_) {
    lane.at_sample = lane.over();
    if (!lane.over()) lane.left = lane.now().steps;
  }
  for (;;) {
    int steps = std::numeric_limits<int>::max();
    bool all_there = true;
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
      setMoving(i, !lanes_[i].at_sample);
      if (lanes_[i].at_sample) continue;
      all_there = false;
      steps = std::min(steps, lanes_[i].left);
    }
    if (all_there) break;
    call({.steps = steps, .intervals = 1, .sample = false});
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
      Lane& lane = lanes_[i];
      if (lane.at_sample) continue;
      lane.left -= steps;
      if (lane.left > 0) continue;
      const LanePlan::Piece& piece = lane.now();
      lane.at_sample = piece.sample;
      const bool changes = changesSegment(lane, 1);
      ++lane.stretch;
      if (changes || (!piece.sample && lane.stretch == piece.stretches)) {
        ++lane.piece;
        enter(i, changes);
      }
      if (!lane.at_sample && lane.over()) lane.at_sample = true;
      if (!lane.at_sample) lane.left = lane.now().steps;
    }
  }
  call({.steps = 0, .intervals = 1});
}

// Pieces that end without a kink, and oscillators that have turned long enough.
void LaneRun::afterSample() {
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    Lane& lane = lanes_[i];
    if (lane.over() || lane.stretch == 0) continue;
    if (lane.stretch == lane.now().stretches) {
      ++lane.piece;
      enter(i, false);
    } else if (lane.stretch % stretchesPerSeed(lane.now().steps) == 0) {
      const LanePlan::Piece& piece = lane.now();
      seed(i, piece.begin + static_cast<double>(lane.stretch) * piece.steps * piece.h);
    }
  }
}

void LaneRun::run(const Kernels& kernels, const Block& block, const Choice& choice, int first_counted) {
  kernels_ = &kernels;
  block_ = &block;
  choice_ = &choice;
  first_counted_ = first_counted;
  number_ = 0;
  call({.steps = 0, .intervals = 1});
  while (!std::all_of(lanes_.begin(), lanes_.end(), [](const Lane& lane) { return lane.over(); })) {
    const int intervals = commonIntervals();
    if (intervals > 0) walkUniform(intervals);
    else walkMixed();
    afterSample();
  }
}

}  // namespace vehicle::ensemble
