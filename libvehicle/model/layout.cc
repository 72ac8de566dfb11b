#include "libvehicle/model/layout.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace vehicle {
namespace {

/// A column that parts of a kind have.
struct OutputRow {
  PartKind part;
  Quantity quantity;
  std::string_view name;
  std::string_view unit;
  bool (*exists)(const Topology& topology, std::size_t index);  // of the part; null: every part of the kind has it
};

bool bodyRises(const Topology& topology, std::size_t body) { return topology.bodies[body].z_index >= 0; }
bool bodyPitches(const Topology& topology, std::size_t body) { return topology.bodies[body].pitch_index >= 0; }
bool wheelsetRises(const Topology& topology, std::size_t wheelset) { return topology.wheelsets[wheelset].z_index >= 0; }

// Every column of a result, in the order in which a part shows them: the one place where columns are listed.
constexpr std::array kOutputs = {
    OutputRow{PartKind::kBody, Quantity::kZ, "z", "m", bodyRises},
    OutputRow{PartKind::kBody, Quantity::kPitch, "pitch", "rad", bodyPitches},
    OutputRow{PartKind::kBody, Quantity::kZRate, "vz", "m/s", bodyRises},
    OutputRow{PartKind::kBody, Quantity::kPitchRate, "pitch_rate", "rad/s", bodyPitches},
    OutputRow{PartKind::kBody, Quantity::kZAcceleration, "az", "m/s^2", bodyRises},
    OutputRow{PartKind::kBody, Quantity::kPitchAcceleration, "pitch_acc", "rad/s^2", bodyPitches},
    OutputRow{PartKind::kSuspension, Quantity::kDeflection, "deflection", "m", nullptr},
    OutputRow{PartKind::kSuspension, Quantity::kForce, "force", "N", nullptr},
    OutputRow{PartKind::kWheelset, Quantity::kRailZ, "rail_z", "m", nullptr},
    OutputRow{PartKind::kWheelset, Quantity::kZ, "z", "m", wheelsetRises},
    OutputRow{PartKind::kWheelset, Quantity::kZRate, "vz", "m/s", wheelsetRises},
    OutputRow{PartKind::kWheelset, Quantity::kZAcceleration, "az", "m/s^2", wheelsetRises},
    OutputRow{PartKind::kWheelset, Quantity::kLoad, "load", "N", nullptr},
    OutputRow{PartKind::kPoint, Quantity::kZ, "z", "m", nullptr},
    OutputRow{PartKind::kPoint, Quantity::kZRate, "vz", "m/s", nullptr},
    OutputRow{PartKind::kPoint, Quantity::kZAcceleration, "az", "m/s^2", nullptr},
};

constexpr std::array kKinds = {PartKind::kBody, PartKind::kSuspension, PartKind::kWheelset, PartKind::kPoint};
constexpr int kQuantities = 1 + static_cast<int>(Quantity::kLoad);

std::vector<const std::string*> namesOf(const Topology& topology, PartKind kind) {
  std::vector<const std::string*> names;
  const auto add = [&](const auto& parts) {
    for (const auto& each : parts) names.push_back(&each.name);
  };
  switch (kind) {
    case PartKind::kBody:
      add(topology.bodies);
      break;
    case PartKind::kSuspension:
      add(topology.suspensions);
      break;
    case PartKind::kWheelset:
      add(topology.wheelsets);
      break;
    case PartKind::kPoint:
      add(topology.points);
      break;
  }
  return names;
}

/// What a column of that quantity changes at; itself where it is the rate of nothing.
Quantity levelQuantity(Quantity rate) {
  switch (rate) {
    case Quantity::kZRate:
      return Quantity::kZ;
    case Quantity::kPitchRate:
      return Quantity::kPitch;
    case Quantity::kZAcceleration:
      return Quantity::kZRate;
    case Quantity::kPitchAcceleration:
      return Quantity::kPitchRate;
    default:
      return rate;
  }
}

/// As results name it.
std::string nameOf(const std::string& part, const OutputRow& row) { return part + '.' + std::string(row.name); }

}  // namespace

OutputLayout::OutputLayout(const Topology& topology) {
  int part_number = 0;
  for (const PartKind kind : kKinds) {
    const std::vector<const std::string*> names = namesOf(topology, kind);
    first_.push_back(part_number);
    part_number += static_cast<int>(names.size());
    columns_.resize(static_cast<std::size_t>(part_number * kQuantities), -1);
    for (std::size_t i = 0; i < names.size(); ++i) {
      int* of_part = columns_.data() + kQuantities * (first_.back() + static_cast<int>(i));
      for (const OutputRow& row : kOutputs) {
        if (row.part != kind || (row.exists != nullptr && !row.exists(topology, i))) continue;
        of_part[static_cast<int>(row.quantity)] = size();
        channels_.push_back({nameOf(*names[i], row), std::string(row.unit)});
        keys_.push_back({kind, static_cast<int>(i), row.quantity});
      }
    }
  }
}

int OutputLayout::column(PartKind part, int index, Quantity quantity) const {
  const int part_number = first_[static_cast<std::size_t>(part)] + index;
  return columns_[static_cast<std::size_t>(part_number * kQuantities + static_cast<int>(quantity))];
}

std::optional<OutputKey> OutputLayout::find(std::string_view name) const {
  const auto found = std::find_if(channels_.begin(), channels_.end(), [&](const Channel& c) { return c.name == name; });
  if (found == channels_.end()) return std::nullopt;
  return keys_[static_cast<std::size_t>(found - channels_.begin())];
}

int OutputLayout::levelOf(int column) const {
  const OutputKey& key = keys_[static_cast<std::size_t>(column)];
  const Quantity level = levelQuantity(key.quantity);
  return level == key.quantity ? -1 : this->column(key.part, key.index, level);
}

std::vector<OutputKey> stateKeys(const Topology& topology) {
  const StateLayout layout{.coordinates = topology.coordinates};
  std::vector<OutputKey> keys(static_cast<std::size_t>(layout.size()));
  const auto put = [&](int coordinate, const OutputKey& level, Quantity rate) {
    if (coordinate < 0) return;
    keys[static_cast<std::size_t>(coordinate)] = level;
    keys[static_cast<std::size_t>(layout.rate(coordinate))] = {level.part, level.index, rate};
  };
  for (int b = 0; const TopologyBody& body : topology.bodies) {
    put(body.z_index, {PartKind::kBody, b, Quantity::kZ}, Quantity::kZRate);
    put(body.pitch_index, {PartKind::kBody, b, Quantity::kPitch}, Quantity::kPitchRate);
    ++b;
  }
  for (int j = 0; const TopologyWheelset& wheelset : topology.wheelsets) {
    put(wheelset.z_index, {PartKind::kWheelset, j, Quantity::kZ}, Quantity::kZRate);
    ++j;
  }
  return keys;
}

std::vector<Channel> stateChannels(const OutputLayout& outputs, const std::vector<OutputKey>& states) {
  std::vector<Channel> channels;
  for (const OutputKey& each : states) {
    channels.push_back(outputs.channels()[static_cast<std::size_t>(outputs.column(each))]);
  }
  return channels;
}

std::vector<Channel> stateChannels(const Topology& topology) {
  return stateChannels(OutputLayout(topology), stateKeys(topology));
}

std::vector<Channel> resultChannels(const Topology& topology) { return OutputLayout(topology).channels(); }

}  // namespace vehicle
