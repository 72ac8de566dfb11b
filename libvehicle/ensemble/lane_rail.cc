#include "libvehicle/ensemble/lane_rail.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libvehicle/integrate/step_walk.h"

namespace vehicle::ensemble {
namespace {

// Steps after which sine and cosine are computed anew: in between each turn rounds, which adds up to about the
// square root of 1024 roundings.
constexpr int kStepsPerSeed = 512;

// Rows of LaneRail::time.
constexpr std::size_t kAnchor = 0, kHalf = 1, kCount = 2, kIncrement = 3;

int intervalsPerSeed(int steps) { return (kStepsPerSeed + steps - 1) / steps; }

}  // namespace

LanePlan::LanePlan(const Input& rail, const Schedule& schedule, FixedStep step)
    : input(&rail), parts(schedule.parts()), cut(schedule.cut()), point_step(schedule.outputStep() / schedule.cut()) {
  const int whole_steps = stepsOf(point_step, step);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Schedule::Part& part = parts[i];
    looks.emplace_back(schedule, part);
    if (part.counts) measured += part.end - part.begin;
    for (std::size_t own = 0; own < part.count;) {
      const std::size_t index = part.first_interval + own;
      const Interval interval = schedule.intervals()[index];
      const StepGrid grid = stepGridFrom(interval, step);
      Piece piece;
      piece.segment = part.segment;
      piece.begin = grid.begin;
      piece.h = grid.h;
      piece.steps = grid.steps;
      piece.intervals = grid.count;
      piece.part = i;
      piece.first = own;
      piece.whole =
          part.finer == 1 && interval.alike > 0 && grid.steps == whole_steps && endsOnPoint(piece, piece.intervals - 1);
      own += static_cast<std::size_t>(grid.count);
      piece.ends_part = own == part.count;
      pieces.push_back(piece);
    }
  }
  const Schedule::Part& end = parts.back();
  const std::int64_t last =
      end.first + static_cast<std::int64_t>(end.count) - 2;  // the point before the end of the run
  points = end.last_regular >= 0 ? end.last_regular + 1 : static_cast<int>(last / end.finer) + 1;
}

bool LanePlan::endsOnPoint(const Piece& piece, int interval) const {
  const Schedule::Part& part = parts[piece.part];
  const std::size_t own = piece.first + static_cast<std::size_t>(interval);
  if (own + 1 == part.count) return part.last_regular >= 0;
  return (part.first + static_cast<std::int64_t>(own)) % part.finer == 0;
}

Look<double> LaneRun::Lane::lookAfter(int further) const {
  return plan->looks[now().part].at(now().first + static_cast<std::size_t>(interval + further) + 1);
}

LaneRun::LaneRun(std::span<const LanePlan* const> plans, std::span<const FlatParameters* const> vehicles)
    : lanes_(plans.size()) {
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    lanes_[i].plan = plans[i];
    lanes_[i].vehicle = vehicles[i];
    for (int k = 0; k < plans[i]->input->segments(); ++k) {
      const InputSegment& segment = plans[i]->input->segment(k);
      requireClosedForm("ensemble", "run each design by itself", segment);
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
  common_.resize(width);
  rail_.frequencies = static_cast<int>(frequencies_);
  rail_.oscillator = oscillator_.data();
  rail_.wheel = wheel_.data();
  rail_.force_polynomial = force_polynomial_.data();
  rail_.wheel_polynomial = wheel_polynomial_.data();
  rail_.half_step = half_step_.data();
  rail_.time = time_.data();
  for (std::size_t i = 0; i < width; ++i) {
    lanes_[i].turn.resize(2 * frequencies_);
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
  lane.interval = 0;
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

// Whole steps of the grid that all lanes can make together; 0: one of them has a sample on the way to the next point.
int LaneRun::commonIntervals() const {
  int most = std::numeric_limits<int>::max();
  for (const Lane& lane : lanes_) {
    if (lane.over()) continue;
    if (!lane.now().whole) return 0;
    const int to_seed = intervalsPerSeed(lane.now().steps);
    most = std::min({most, lane.now().intervals - lane.interval, to_seed - lane.interval % to_seed});
  }
  return most;
}

void LaneRun::clearLooks(int intervals) {
  const std::size_t rows = static_cast<std::size_t>(intervals) * kLookRows;
  if (looks_.size() < rows * lanes_.size()) looks_ = AlignedDoubles(rows * lanes_.size());
  std::fill_n(looks_.data(), rows * lanes_.size(), 0.0);
}

void LaneRun::setLook(int interval, std::size_t lane, const Look<double>& look) {
  const std::size_t first = static_cast<std::size_t>(interval) * kLookRows;
  at(looks_, first, lane) = look.weight;
  at(looks_, first + 1, lane) = look.per_last;
  at(looks_, first + 2, lane) = look.per_before;
}

// Steps without a sample at their end.
void LaneRun::step(int steps) { kernels_->runLanes(*block_, *choice_, rail_, {.steps = steps}); }

// Intervals whose ends are points of all lanes.
void LaneRun::meet(int steps, int intervals) {
  LaneLeg leg;
  leg.steps = steps;
  leg.intervals = intervals;
  leg.looks = looks_.data();
  leg.number = number_;
  leg.stored = number_ - first_stored_;
  kernels_->runLanes(*block_, *choice_, rail_, leg);
  number_ += intervals;
}

// A sample of those lanes alone that have a look.
void LaneRun::lookAlone() {
  LaneLeg leg;
  leg.looks = looks_.data();
  kernels_->runLanes(*block_, *choice_, rail_, leg);
}

// The lane is behind the last interval of its piece.
void LaneRun::nextPiece(std::size_t index) {
  Lane& lane = lanes_[index];
  const int segment = lane.now().segment;
  ++lane.piece;
  enter(index, !lane.over() && lane.now().segment != segment);
}

void LaneRun::walkUniform(int intervals) {
  int steps = 0;
  bool ends = false;
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    if (!lanes_[i].over()) steps = lanes_[i].now().steps;
    setMoving(i, !lanes_[i].over());
    ends = ends || lanes_[i].endsPart(intervals);
  }
  const int together = ends ? intervals - 1 : intervals;
  clearLooks(std::max(together, 1));
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    for (int k = 0; k < together && !lanes_[i].over(); ++k) setLook(k, i, lanes_[i].lookAfter(k));
  }
  if (together > 0) meet(steps, together);
  if (!ends) {
    for (Lane& lane : lanes_) lane.interval += lane.over() ? 0 : intervals;
    return;
  }
  // The last point is the end of a part for some: seen from before it, then, with all others, from behind.
  step(steps);
  clearLooks(1);
  std::vector<char> ending;
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    ending.push_back(lanes_[i].endsPart(intervals) ? 1 : 0);
    if (!lanes_[i].over()) common_[i] = lanes_[i].lookAfter(intervals - 1);
    if (ending.back() != 0) setLook(0, i, common_[i]);
  }
  lookAlone();
  clearLooks(1);
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    Lane& lane = lanes_[i];
    if (lane.over()) continue;
    lane.interval += intervals;
    if (ending[i] != 0) {
      nextPiece(i);
      common_[i] = lane.over() ? Look<double>{} : lane.lookAtBegin();
    }
    setLook(0, i, common_[i]);
  }
  meet(0, 1);
}

// A lane that has come to the end of an interval on its way to the next point; `looks_` gets what it alone has to look at.
void LaneRun::finishInterval(std::size_t index) {
  Lane& lane = lanes_[index];
  const LanePlan::Piece& piece = lane.now();
  const bool last = lane.interval + 1 == piece.intervals;
  const Look<double> look = lane.lookAfter(0);
  lane.at_point = lane.plan->endsOnPoint(piece, lane.interval);
  common_[index] = look;
  if (!lane.at_point || (last && piece.ends_part)) setLook(0, index, look);
}

void LaneRun::walkMixed() {
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    Lane& lane = lanes_[i];
    lane.at_point = lane.over();
    common_[i] = {};
    if (!lane.over()) lane.left = lane.now().steps;
  }
  for (;;) {
    int steps = std::numeric_limits<int>::max();
    bool all_there = true;
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
      setMoving(i, !lanes_[i].at_point);
      if (lanes_[i].at_point) continue;
      all_there = false;
      steps = std::min(steps, lanes_[i].left);
    }
    if (all_there) break;
    step(steps);
    std::vector<std::size_t> finished;
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
      if (lanes_[i].at_point) continue;
      lanes_[i].left -= steps;
      if (lanes_[i].left == 0) finished.push_back(i);
    }
    if (finished.empty()) continue;
    clearLooks(1);
    for (const std::size_t i : finished) finishInterval(i);
    lookAlone();
    clearLooks(1);
    for (const std::size_t i : finished) {
      Lane& lane = lanes_[i];
      const bool ends_part = lane.endsPart(1);
      if (++lane.interval < lane.now().intervals) {
        if (!lane.at_point) lane.left = lane.now().steps;
        continue;
      }
      // A piece that goes on after a point of the grid is left to reseed(), as in walkUniform().
      if (lane.at_point && !ends_part) continue;
      nextPiece(i);
      if (lane.over()) {
        lane.at_point = true;
        common_[i] = {};
        continue;
      }
      if (ends_part && lane.at_point) common_[i] = lane.lookAtBegin();
      if (ends_part && !lane.at_point) setLook(0, i, lane.lookAtBegin());
      if (!lane.at_point) lane.left = lane.now().steps;
    }
    lookAlone();
  }
  if (number_ == points_) return;  // the last runs have ended between two points
  clearLooks(1);
  for (std::size_t i = 0; i < lanes_.size(); ++i) setLook(0, i, common_[i]);
  meet(0, 1);
}

// Pieces that end inside a part, and oscillators that have turned long enough.
void LaneRun::reseed() {
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    Lane& lane = lanes_[i];
    if (lane.over() || lane.interval == 0) continue;
    if (lane.interval == lane.now().intervals) {
      nextPiece(i);
    } else if (lane.interval % intervalsPerSeed(lane.now().steps) == 0) {
      const LanePlan::Piece& piece = lane.now();
      seed(i, piece.begin + static_cast<double>(lane.interval) * piece.steps * piece.h);
    }
  }
}

void LaneRun::run(const Kernels& kernels, const Block& block, const Choice& choice, int first_stored) {
  kernels_ = &kernels;
  block_ = &block;
  choice_ = &choice;
  first_stored_ = first_stored;
  number_ = 0;
  points_ = 0;
  for (const Lane& lane : lanes_) points_ = std::max(points_, lane.plan->points);
  clearLooks(1);
  for (std::size_t i = 0; i < lanes_.size(); ++i) setLook(0, i, lanes_[i].lookAtBegin());
  meet(0, 1);
  while (!std::all_of(lanes_.begin(), lanes_.end(), [](const Lane& lane) { return lane.over(); })) {
    const int intervals = commonIntervals();
    if (intervals > 0) walkUniform(intervals);
    else walkMixed();
    reseed();
  }
}

}  // namespace vehicle::ensemble
