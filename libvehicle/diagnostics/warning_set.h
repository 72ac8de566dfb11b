#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/diagnostics/warning.h"

namespace vehicle {

/// Kinds of warnings, each at most once: what millions of designs keep of theirs. Trivially copyable.
class WarningSet {
 public:
  void insert(WarningCode code) { bits_ |= bitOf(code); }
  [[nodiscard]] bool contains(WarningCode code) const { return (bits_ & bitOf(code)) != 0; }
  [[nodiscard]] bool empty() const { return bits_ == 0; }

  /// In the order of the enumerators.
  [[nodiscard]] std::vector<WarningCode> codes() const;
  /// Their words with spaces between: "WHEEL_LOAD LARGE_MOTION"; "" for none.
  [[nodiscard]] std::string words() const;
  /// What words() wrote; a word that this program does not know is left out.
  [[nodiscard]] static WarningSet ofWords(std::string_view words);

  bool operator==(const WarningSet&) const = default;

 private:
  static std::uint32_t bitOf(WarningCode code) { return std::uint32_t{1} << static_cast<unsigned>(code); }
  std::uint32_t bits_ = 0;
};

}  // namespace vehicle
