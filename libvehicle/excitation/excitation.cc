#include "libvehicle/excitation/excitation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/definition/judge.h"
#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/excitation/wheel_on_rail.h"
#include "libvehicle/system/schedule.h"
#include "libvehicle/track/rail_profile.h"
#include "libvehicle/units/quantity.h"

namespace vehicle {
namespace {

constexpr double kShortestPassage = 1e-8;  // of an output step: both ends of a feature stay apart

[[noreturn]] void refuse(const Origin& origin, std::string_view element, std::string message, std::string remedy) {
  ProblemList problems;
  Judge(problems, element, "", origin).say(std::move(message), std::move(remedy));
  throw InvalidInput(std::move(problems));
}

// A value of the scenario as its file says it.
std::string inFile(const Origin& origin, std::string_view attribute, double value, Dimension dimension) {
  ProblemList none;
  return Judge(none, "", "", origin).written(attribute, value, dimension);
}

double endOf(const Run& run, const Travel& travel) {
  if (!run.duration && !run.distance) {
    refuse(run.origin, "<scenario><run>", "has no duration and no distance", "give one of them");
  }
  const double end = run.duration ? *run.duration : travel.time(*run.distance);
  if (!(run.output_step > 0.0) || !(end >= run.output_step * (1.0 - kSameInstant)) || !std::isfinite(end)) {
    refuse(run.origin, "<scenario><run>",
           fmt::format("lasts {} with {}; must last at least one output step", formatQuantity(end, Dimension::kTime),
                       inFile(run.origin, "output_step", run.output_step, Dimension::kTime)),
           "run longer, or take a shorter output_step");
  }
  const int sample = sampleAt(0.0, run.output_step, end);
  return sample > 0 ? SampleGrid(0.0, run.output_step).time(sample) : end;
}

// Before an onset the rail is flat at 0: the profile must begin there too.
void checkOnset(const Track& track) {
  if (track.history != History::kOnset) return;
  Track waves = track;
  waves.dips.clear();
  waves.bumps.clear();
  waves.ramps.clear();
  const double total = railHeight(track, 0.0);
  const double harmonic = railHeight(waves, 0.0);
  double amplitudes = 0.0;
  for (const Harmonic& each : track.harmonics) amplitudes += std::abs(each.amplitude);
  for (const Dip& each : track.dips) amplitudes += std::abs(each.depth);
  for (const Bump& each : track.bumps) amplitudes += std::abs(each.height);
  for (const Ramp& each : track.ramps) amplitudes += std::abs(each.rise);
  const double rounding = 1e-12 * amplitudes;  // a phase of pi leaves 1e-16 of its amplitude
  if (std::abs(total) <= rounding) return;
  refuse(track.origin, "<scenario><track>",
         fmt::format("the height jumps by {:g} m where history=\"onset\" begins (s = 0); must begin at 0", total),
         std::abs(harmonic) > rounding ? "give fade_in=\"50 m\", or take history=\"extended\""
                                       : "let dips, bumps and ramps start at 0 or beyond, or take history=\"extended\"");
}

void checkPassage(const Origin& origin, const char* element, const char* attribute, double length, double speed,
                  double output_step) {
  const double shortest = kShortestPassage * output_step * speed;
  if (length > shortest) return;
  refuse(origin, element,
         fmt::format("{} is passed in no time; must be > {:g} m at {:g} m/s",
                     inFile(origin, attribute, length, Dimension::kLength), shortest, speed),
         "make it longer, or take a shorter output_step");
}

void checkTrack(const Track& track, double speed, double output_step) {
  checkOnset(track);
  if (track.history == History::kOnset && track.fade_in) {
    checkPassage(track.origin, "<scenario><track>", "fade_in", *track.fade_in, speed, output_step);
  }
  for (const Dip& each : track.dips) {
    checkPassage(each.origin, "<scenario><track><dip>", "length", each.length, speed, output_step);
  }
  for (const Bump& each : track.bumps) {
    checkPassage(each.origin, "<scenario><track><bump>", "length", each.length, speed, output_step);
  }
  for (const Ramp& each : track.ramps) {
    checkPassage(each.origin, "<scenario><track><ramp>", "length", each.length, speed, output_step);
  }
}

// A rail in pieces, and what messages about it say.
struct Rail {
  const std::vector<RailPiece>& pieces;
  Origin origin;
  History history = History::kExtended;
};

// The vehicle on its way: how far each wheelset is behind the leading one, and how all of them run.
struct Wheels {
  std::vector<double> lags;  // [m]
  std::shared_ptr<const Travel> travel;
};

// A wheel over a piece of rail, on the segments first .. last - 1 of the run.
struct Passage {
  std::size_t wheel = 0;
  const RailPiece* piece = nullptr;
  std::shared_ptr<const RailMotion> motion;  // none: it has a closed form
  std::size_t first = 0;
  std::size_t last = 0;
};

std::vector<Passage> passagesOf(const Rail& rail, const Wheels& wheels) {
  std::vector<Passage> passages;
  for (const RailPiece& piece : rail.pieces) {
    std::shared_ptr<const RailPiece> shared;
    if (piece.samples || !wheels.travel->isUniform()) shared = std::make_shared<RailPiece>(piece);
    for (std::size_t j = 0; j < wheels.lags.size(); ++j) {
      Passage& passage = passages.emplace_back();
      passage.wheel = j;
      passage.piece = &piece;
      if (!shared || piece.isStep()) continue;
      passage.motion = std::make_shared<WheelOnRail>(shared, wheels.travel, wheels.lags[j]);
    }
  }
  return passages;
}

// How far each wheelset is behind the leading one [m], in the order of the topology (any order in the file).
std::vector<double> lagsOf(const Topology& topology) {
  double lead = -std::numeric_limits<double>::infinity();
  for (const TopologyWheelset& each : topology.wheelsets) lead = std::max(lead, each.x);
  std::vector<double> lags;
  for (const TopologyWheelset& each : topology.wheelsets) lags.push_back(lead - each.x);
  return lags;
}

// Borders of the run in time, and which of them each passage begins and ends at. Passages outside the run go.
std::vector<double> cut(std::vector<Passage>& passages, const Wheels& wheels, const RunLength& run) {
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  struct Event {
    double time;
    std::size_t passage;
    bool begins;
  };
  const double same = kSameInstant * run.output_step;
  const double end = run.end;
  const auto timeOf = [&](double s, std::size_t wheel) { return wheels.travel->time(s + wheels.lags[wheel]); };
  std::erase_if(passages, [&](const Passage& each) {
    return timeOf(each.piece->to, each.wheel) <= same || timeOf(each.piece->from, each.wheel) >= end - same;
  });
  std::vector<Event> events;
  for (std::size_t i = 0; i < passages.size(); ++i) {
    const Passage& each = passages[i];
    const double from = timeOf(each.piece->from, each.wheel);
    const double to = timeOf(each.piece->to, each.wheel);
    if (from > same) events.push_back({from, i, true});
    if (to < end - same) events.push_back({to, i, false});
  }
  for (const double jump : wheels.travel->jumps()) {
    if (jump < end - same) events.push_back({jump, kNone, true});
  }
  std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.time < b.time; });

  const SampleGrid grid(0.0, run.output_step);
  std::vector<double> borders{0.0};
  for (const Event& event : events) {
    const int sample = sampleAt(0.0, run.output_step, event.time);
    const double time = sample >= 0 ? grid.time(sample) : event.time;
    if (time - borders.back() > same) borders.push_back(time);
    if (event.passage == kNone) continue;
    (event.begins ? passages[event.passage].first : passages[event.passage].last) = borders.size() - 1;
  }
  for (Passage& each : passages) {
    if (!(timeOf(each.piece->to, each.wheel) < end - same)) each.last = borders.size();
  }
  borders.push_back(end);
  return borders;
}

// Refuses what would fill the memory, before it does.
void checkSize(const Rail& rail, const std::vector<Passage>& passages, std::size_t segments, std::size_t wheels) {
  std::set<double> wavenumbers;
  std::vector<double> terms(segments + 1, 0.0);  // of each segment: first where they come and go, then summed up
  for (const Passage& each : passages) {
    for (const RailWave& wave : each.piece->waves) wavenumbers.insert(wave.wavenumber);
    if (each.first >= segments) continue;
    terms[each.first] += static_cast<double>(each.piece->waves.size());
    terms[std::min(each.last, segments)] -= static_cast<double>(each.piece->waves.size());
  }
  double values = 0.0;
  double active = 0.0;
  for (std::size_t i = 0; i < segments; ++i) {
    active += terms[i];
    const double frequencies = std::min(active, static_cast<double>(wavenumbers.size()));
    // As told and as packed for the sums: two and four numbers a frequency, four and eight of the polynomial.
    values += static_cast<double>(wheels) * (6.0 * frequencies + 3.0 * InputSegment::kPolynomial);
  }
  const double bytes = values * sizeof(double);
  if (bytes <= kMostInputBytes) return;
  constexpr double kGibibyte = 1024.0 * 1024.0 * 1024.0;
  refuse(rail.origin, "<scenario><track>",
         fmt::format("{} wheelsets pass the discontinuities of the rail at different times: {} segments of input would "
                     "take {:.3g} GiB; must be "
                     "at most {:.3g} GiB",
                     wheels, segments, bytes / kGibibyte, kMostInputBytes / kGibibyte),
         rail.history == History::kOnset ? "take history=\"extended\", or a shorter train or run"
                                         : "take a shorter train or run, or fewer dips, bumps and ramps");
}

// A sinusoid of one wheel, in the time that counts from the beginning of a segment.
struct Term {
  double angular_frequency;
  std::size_t wheel;
  double cosine;
  double sine;
};

void setTerms(InputSegment& segment, std::vector<Term> terms, std::size_t wheels) {
  std::stable_sort(terms.begin(), terms.end(),
                   [](const Term& a, const Term& b) { return a.angular_frequency < b.angular_frequency; });
  std::vector<double>& omega = segment.angular_frequency;
  for (const Term& each : terms) omega.push_back(each.angular_frequency);
  omega.erase(std::unique(omega.begin(), omega.end()), omega.end());
  segment.cosine.assign(wheels * omega.size(), 0.0);
  segment.sine.assign(wheels * omega.size(), 0.0);
  std::size_t f = 0;
  for (const Term& each : terms) {
    while (omega[f] != each.angular_frequency) ++f;
    segment.cosine[each.wheel * omega.size() + f] += each.cosine;
    segment.sine[each.wheel * omega.size() + f] += each.sine;
  }
}

// The closed form of a piece at constant speed, in the time that counts from the beginning of a segment.
// @param x  [m] from the piece's origin to the wheel at that time
void addClosedForm(const Passage& passage, double x, double speed, InputSegment& segment, std::vector<Term>& terms) {
  const RailPiece& piece = *passage.piece;
  double* polynomial = segment.polynomial.data() + InputSegment::kPolynomial * passage.wheel;
  polynomial[0] += piece.level + piece.slope * x;
  polynomial[1] += piece.slope * speed;
  for (const RailWave& wave : piece.waves) {
    const double sine = std::sin(wave.wavenumber * x);
    const double cosine = std::cos(wave.wavenumber * x);
    terms.push_back({wave.wavenumber * speed, passage.wheel, wave.cosine * cosine + wave.sine * sine,
                     wave.sine * cosine - wave.cosine * sine});
  }
}

InputSegment segmentOf(double begin, double end, const Wheels& wheels, const std::vector<double>& levels,
                       const std::vector<const Passage*>& active) {
  InputSegment segment;
  segment.begin = begin;
  segment.end = end;
  segment.polynomial.assign(wheels.lags.size() * InputSegment::kPolynomial, 0.0);
  for (std::size_t j = 0; j < wheels.lags.size(); ++j) segment.polynomial[InputSegment::kPolynomial * j] = levels[j];
  std::vector<Term> terms;
  for (const Passage* passage : active) {
    if (passage->motion) {
      segment.sampled.push_back({static_cast<int>(passage->wheel), 1.0, passage->motion});
      continue;
    }
    // Rounded once where the wheel stands near the piece's origin: the phase is then as good as the time itself.
    const double x = wheels.travel->distance(begin, wheels.lags[passage->wheel]) - passage->piece->origin;
    addClosedForm(*passage, x, wheels.travel->speed(begin), segment, terms);
  }
  setTerms(segment, std::move(terms), wheels.lags.size());
  return segment;
}

Input inputOn(const Rail& rail, const Wheels& wheels, const RunLength& run) {
  std::vector<Passage> passages = passagesOf(rail, wheels);
  const std::vector<double> borders = cut(passages, wheels, run);
  checkSize(rail, passages, borders.size() - 1, wheels.lags.size());

  std::stable_sort(passages.begin(), passages.end(),
                   [](const Passage& a, const Passage& b) { return a.first < b.first; });
  std::vector<InputSegment> segments;
  std::vector<double> levels(wheels.lags.size(), 0.0);
  std::vector<const Passage*> active;
  auto coming = passages.begin();
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    std::erase_if(active, [&](const Passage* each) { return each->last <= i; });
    for (; coming != passages.end() && coming->first == i; ++coming) {
      // Level from then on: summed once instead of being carried through all segments that follow.
      if (coming->piece->isStep()) {
        levels[coming->wheel] += coming->piece->level;
      } else if (coming->last > i) {
        active.push_back(&*coming);
      }
    }
    segments.push_back(segmentOf(borders[i], borders[i + 1], wheels, levels, active));
  }
  return Input(static_cast<int>(wheels.lags.size()), std::move(segments));
}

Input rigInput(const Rig& rig, const Topology& topology, double end) {
  std::vector<Term> terms;
  for (const RigInput& input : rig.inputs) {
    const auto found = std::find_if(topology.wheelsets.begin(), topology.wheelsets.end(),
                                    [&](const TopologyWheelset& each) { return each.name == input.wheelset; });
    if (found == topology.wheelsets.end()) {
      std::vector<std::string> names;
      for (const TopologyWheelset& each : topology.wheelsets) names.push_back(each.name);
      const auto nearest = nearestName(input.wheelset, names);
      refuse(input.origin, "<scenario><rig><input>",
             fmt::format("wheelset=\"{}\" names no wheelset of the vehicle", input.wheelset),
             nearest ? fmt::format("did you mean \"{}\"?", *nearest) : "name one of its wheelsets");
    }
    const auto wheel = static_cast<std::size_t>(found - topology.wheelsets.begin());
    for (const RigSine& each : input.sines) {
      terms.push_back({angularFrequencyOf(each), wheel, each.amplitude * std::sin(each.phase),
                       each.amplitude * std::cos(each.phase)});
    }
  }
  InputSegment segment;
  segment.begin = 0.0;
  segment.end = end;
  segment.polynomial.assign(topology.wheelsets.size() * InputSegment::kPolynomial, 0.0);
  setTerms(segment, std::move(terms), topology.wheelsets.size());
  return Input(static_cast<int>(topology.wheelsets.size()), {std::move(segment)});
}

}  // namespace

Input inputOf(const Scenario& scenario, const Topology& topology, double speed) {
  if (scenario.track.has_value() == scenario.rig.has_value()) {
    refuse(scenario.origin, "<scenario>", "has no or two of <track> and <rig>", "give one of them");
  }
  // On a rig nothing runs, and its speed may be anything as long as no distance is asked for.
  const bool stands = scenario.rig && scenario.run.duration;
  const Travel travel(stands ? 1.0 : speed);
  const double end = endOf(scenario.run, travel);
  if (scenario.rig) return rigInput(*scenario.rig, topology, end);
  checkTrack(*scenario.track, speed, scenario.run.output_step);
  const std::vector<RailPiece> pieces = piecesOf(*scenario.track);
  return inputOn({pieces, scenario.track->origin, scenario.track->history},
                 {lagsOf(topology), std::make_shared<Travel>(travel)}, {end, scenario.run.output_step});
}

Input inputOf(const std::vector<RailPiece>& rail, const Topology& topology, const Travel& travel,
              const RunLength& run) {
  if (!(run.output_step > 0.0 && run.end >= run.output_step * (1.0 - kSameInstant) && std::isfinite(run.end))) {
    throw std::invalid_argument(
        fmt::format("inputOf: a run of {} s with an output step of {} s, must last at least one of them", run.end,
                    run.output_step));
  }
  return inputOn({rail, {}}, {lagsOf(topology), std::make_shared<Travel>(travel)}, run);
}

std::vector<double> breakpointsOf(const Input& input) {
  std::vector<double> breakpoints;
  for (int i = 1; i < input.segments(); ++i) breakpoints.push_back(input.segment(i).begin);
  return breakpoints;
}

}  // namespace vehicle
