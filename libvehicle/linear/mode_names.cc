#include "libvehicle/linear/mode_names.h"

#include <array>
#include <map>
#include <string_view>
#include <utility>

namespace vehicle {
namespace {

constexpr double kShares = 0.5;  // of the leading coordinate's participation

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kMotions = {{{"z", "bounce"},
                                                                                    {"pitch", "pitch"},
                                                                                    {"roll", "roll"},
                                                                                    {"yaw", "yaw"},
                                                                                    {"y", "sway"},
                                                                                    {"x", "surge"}}};

struct Coordinate {
  std::string part;
  std::string motion;
};

Coordinate coordinateOf(const Channel& state) {
  const std::size_t dot = state.name.rfind('.');
  if (dot == std::string::npos) return {state.name, "motion"};
  const std::string kind = state.name.substr(dot + 1);
  for (const auto& [suffix, word] : kMotions) {
    if (kind == suffix) return {state.name.substr(0, dot), std::string(word)};
  }
  return {state.name.substr(0, dot), kind};
}

// Coordinates of one motion that share the lead, and what they carry together.
struct Lead {
  std::vector<Eigen::Index> coordinates;
  double share = 0.0;
};

Lead leadOf(const Mode& mode, const std::vector<Coordinate>& coordinates, const std::string& motion) {
  const auto moves = [&](Eigen::Index i) { return coordinates[static_cast<std::size_t>(i)].motion == motion; };
  double largest = 0.0;
  for (Eigen::Index i = 0; i < mode.shape.size(); ++i) {
    if (moves(i)) largest = std::max(largest, mode.participation(i));
  }
  Lead lead;
  for (Eigen::Index i = 0; i < mode.shape.size(); ++i) {
    if (!moves(i) || mode.participation(i) < kShares * largest) continue;
    lead.coordinates.push_back(i);
    lead.share += mode.participation(i);
  }
  return lead;
}

std::string nameOf(const Mode& mode, const std::vector<Coordinate>& coordinates) {
  Lead lead;
  std::string motion;
  for (const Coordinate& coordinate : coordinates) {
    Lead candidate = leadOf(mode, coordinates, coordinate.motion);
    // Equal but for rounding: the first coordinate's motion, whatever the last bit says.
    if (candidate.share <= lead.share * (1.0 + 1e-9)) continue;
    lead = std::move(candidate);
    motion = coordinate.motion;
  }
  if (lead.coordinates.empty()) return "motion";
  std::string name;
  std::string signs;  // one a part, each after a blank
  const std::complex<double> first = mode.shape(lead.coordinates.front());
  for (const Eigen::Index i : lead.coordinates) {
    const bool opposite = std::real(mode.shape(i) * std::conj(first)) < 0.0;
    if (!name.empty()) name.append(" + ");
    name.append(coordinates[static_cast<std::size_t>(i)].part);
    signs.append(opposite ? " -" : " +");
  }
  name.append(1, ' ').append(motion);
  if (lead.coordinates.size() == 2) name.append(signs == " + +" ? " in phase" : " in antiphase");
  if (lead.coordinates.size() > 2) name.append(" (").append(signs, 1).append(1, ')');
  if (mode.eigenvalue == 0.0) {
    name.append(", free");
  } else if (mode.eigenvalue.imag() == 0.0) {
    name.append(", aperiodic");
  }
  return name;
}

}  // namespace

void nameModes(std::vector<Mode>& modes, const std::vector<Channel>& states) {
  std::vector<Coordinate> coordinates;
  for (std::size_t i = 0; i < states.size() / 2; ++i) coordinates.push_back(coordinateOf(states[i]));
  std::map<std::string, int> used;
  for (Mode& mode : modes) {
    mode.name = nameOf(mode, coordinates);
    const int count = ++used[mode.name];
    if (count > 1) mode.name.append(" (").append(std::to_string(count)).append(1, ')');
  }
}

}  // namespace vehicle
