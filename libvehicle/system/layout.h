#pragma once

namespace vehicle {

/// Where a system's states stand in x: coordinates q, then their rates q', then internal states z of its force laws (an
/// air spring's, a friction element's), shape (size).
struct StateLayout {
  int coordinates = 0;  // N
  int internal = 0;     // states that are the rate of nothing

  [[nodiscard]] int size() const { return 2 * coordinates + internal; }
  [[nodiscard]] int rate(int coordinate) const { return coordinates + coordinate; }
  [[nodiscard]] int internalState(int number) const { return 2 * coordinates + number; }
  bool operator==(const StateLayout&) const = default;
};

/// Where the rail under each wheelset stands in u: heights eta of all channels, their rates, and, where accelerations are
/// asked for, these: shape (w), (2 w) or (3 w).
struct InputLayout {
  int channels = 0;  // w

  /// @param order  how many of heights, rates, accelerations are given: 1..3
  [[nodiscard]] int size(int order) const { return order * channels; }
  [[nodiscard]] int rate(int channel) const { return channels + channel; }
  [[nodiscard]] int acceleration(int channel) const { return 2 * channels + channel; }
};

}  // namespace vehicle
