#include "libvehicle/excitation/excitation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/definition/judge.h"
#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/excitation/rail_piece.h"
#include "libvehicle/excitation/rail_profile.h"
#include "libvehicle/system/schedule.h"
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

void needSpeed(double speed) {
  if (speed > 0.0 && std::isfinite(speed)) return;
  throw std::invalid_argument(fmt::format("inputOf: speed = {} m/s, must be finite and > 0", speed));
}

double endOf(const Run& run, double speed) {
  if (!run.duration && !run.distance) {
    refuse(run.origin, "<scenario><run>", "has no duration and no distance", "give one of them");
  }
  if (!run.duration) needSpeed(speed);
  const double end = run.duration ? *run.duration : *run.distance / speed;
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

// A wheel over a piece of rail, on the segments first .. last - 1 of the run.
struct Passage {
  std::size_t wheel = 0;
  const RailPiece* piece = nullptr;
  std::size_t first = 0;
  std::size_t last = 0;

  // Level from then on: summed once instead of being carried through all segments that follow.
  bool isStep() const { return piece->slope == 0.0 && piece->waves.empty() && std::isinf(piece->to); }
};

// How far each wheelset is behind the leading one [m], in the order of the topology (any order in the file).
std::vector<double> lagsOf(const Topology& topology) {
  double lead = -std::numeric_limits<double>::infinity();
  for (const TopologyWheelset& each : topology.wheelsets) lead = std::max(lead, each.x);
  std::vector<double> lags;
  for (const TopologyWheelset& each : topology.wheelsets) lags.push_back(lead - each.x);
  return lags;
}

// Borders of the run in time, and which of them each passage begins and ends at. Passages outside the run go.
std::vector<double> cut(std::vector<Passage>& passages, const std::vector<double>& lags, double speed, double end,
                        double output_step) {
  struct Event {
    double time;
    std::size_t passage;
    bool begins;
  };
  const double same = kSameInstant * output_step;
  const auto timeOf = [&](double s, std::size_t wheel) { return (s + lags[wheel]) / speed; };
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
  std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.time < b.time; });

  const SampleGrid grid(0.0, output_step);
  std::vector<double> borders{0.0};
  for (const Event& event : events) {
    const int sample = sampleAt(0.0, output_step, event.time);
    const double time = sample >= 0 ? grid.time(sample) : event.time;
    if (time - borders.back() > same) borders.push_back(time);
    (event.begins ? passages[event.passage].first : passages[event.passage].last) = borders.size() - 1;
  }
  for (Passage& each : passages) {
    if (!(timeOf(each.piece->to, each.wheel) < end - same)) each.last = borders.size();
  }
  borders.push_back(end);
  return borders;
}

// Refuses what would fill the memory, before it does.
void checkSize(const Track& track, const std::vector<Passage>& passages, std::size_t segments, std::size_t wheels) {
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
  refuse(track.origin, "<scenario><track>",
         fmt::format("{} wheelsets pass the discontinuities of the rail at different times: {} segments of input would "
                     "take {:.3g} GiB; must be "
                     "at most {:.3g} GiB",
                     wheels, segments, bytes / kGibibyte, kMostInputBytes / kGibibyte),
         track.history == History::kOnset ? "take history=\"extended\", or a shorter train or run"
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

InputSegment segmentOf(double begin, double end, double speed, const std::vector<double>& lags,
                       const std::vector<double>& levels, const std::vector<const Passage*>& active) {
  InputSegment segment;
  segment.begin = begin;
  segment.end = end;
  segment.polynomial.assign(lags.size() * InputSegment::kPolynomial, 0.0);
  for (std::size_t j = 0; j < lags.size(); ++j) segment.polynomial[InputSegment::kPolynomial * j] = levels[j];
  std::vector<Term> terms;
  for (const Passage* passage : active) {
    const RailPiece& piece = *passage->piece;
    // Rounded once where the wheel stands near the piece's origin: the phase is then as good as the time itself.
    const double x = std::fma(speed, begin, -lags[passage->wheel]) - piece.origin;
    double* polynomial = segment.polynomial.data() + InputSegment::kPolynomial * passage->wheel;
    polynomial[0] += piece.level + piece.slope * x;
    polynomial[1] += piece.slope * speed;
    for (const RailWave& wave : piece.waves) {
      const double sine = std::sin(wave.wavenumber * x);
      const double cosine = std::cos(wave.wavenumber * x);
      terms.push_back({wave.wavenumber * speed, passage->wheel, wave.cosine * cosine + wave.sine * sine,
                       wave.sine * cosine - wave.cosine * sine});
    }
  }
  setTerms(segment, std::move(terms), lags.size());
  return segment;
}

Input trackInput(const Track& track, const Topology& topology, double speed, double end, double output_step) {
  checkTrack(track, speed, output_step);
  const std::vector<double> lags = lagsOf(topology);
  const std::vector<RailPiece> pieces = piecesOf(track);
  std::vector<Passage> passages;
  for (const RailPiece& piece : pieces) {
    for (std::size_t j = 0; j < lags.size(); ++j) passages.push_back({j, &piece, 0, 0});
  }
  const std::vector<double> borders = cut(passages, lags, speed, end, output_step);
  checkSize(track, passages, borders.size() - 1, lags.size());

  std::stable_sort(passages.begin(), passages.end(),
                   [](const Passage& a, const Passage& b) { return a.first < b.first; });
  std::vector<InputSegment> segments;
  std::vector<double> levels(lags.size(), 0.0);
  std::vector<const Passage*> active;
  auto coming = passages.begin();
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    std::erase_if(active, [&](const Passage* each) { return each->last <= i; });
    for (; coming != passages.end() && coming->first == i; ++coming) {
      if (coming->isStep()) {
        levels[coming->wheel] += coming->piece->level;
      } else if (coming->last > i) {
        active.push_back(&*coming);
      }
    }
    segments.push_back(segmentOf(borders[i], borders[i + 1], speed, lags, levels, active));
  }
  return Input(static_cast<int>(lags.size()), std::move(segments));
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
  if (scenario.track) needSpeed(speed);
  const double end = endOf(scenario.run, speed);
  return scenario.rig ? rigInput(*scenario.rig, topology, end)
                      : trackInput(*scenario.track, topology, speed, end, scenario.run.output_step);
}

std::vector<double> breakpointsOf(const Input& input) {
  std::vector<double> breakpoints;
  for (int i = 1; i < input.segments(); ++i) breakpoints.push_back(input.segment(i).begin);
  return breakpoints;
}

}  // namespace vehicle
