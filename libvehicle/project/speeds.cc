#include "libvehicle/project/speeds.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "libvehicle/units/quantity.h"

namespace vehicle {

namespace {

constexpr std::size_t kMostSpeeds = 1000;
constexpr double kKilometresPerHour = 3.6;

[[noreturn]] void refuse(std::string_view text, std::string_view message, std::string_view remedy) {
  throw std::invalid_argument(fmt::format("\"{}\" {}; {}", text, message, remedy));
}

std::string trimmed(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return std::string(text);
}

std::vector<std::string> partsAt(char separator, std::string_view text) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

double speedOf(const std::string& text) {
  const ParsedQuantity quantity = parseQuantity(text, Dimension::kSpeed);
  if (!quantity.si) refuse(text, quantity.message, quantity.remedy);
  if (!(std::isfinite(*quantity.si) && *quantity.si > 0.0)) {
    refuse(text, "must be finite and > 0", "give a speed, e.g. \"72 km/h\"");
  }
  return *quantity.si;
}

/// A number of a range in the range's unit.
double numberOf(const std::string& part, const std::string& range) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
  if (error == std::errc() && end == part.data() + part.size() && std::isfinite(value) && value > 0.0) return value;
  refuse(range, fmt::format("has \"{}\" where a number > 0 is expected", part), "write it as \"80:10:160 km/h\"");
}

/// "80:10:160 km/h". Every speed is read as if it had been written by itself.
void addRange(const std::string& text, std::vector<double>& speeds) {
  const std::vector<std::string> parts = partsAt(':', text);
  if (parts.size() != 3) refuse(text, "is no range", "write FROM:STEP:TO UNIT, e.g. \"80:10:160 km/h\"");
  const std::size_t end = parts[2].find_first_not_of("+-.0123456789eE");
  if (end == std::string::npos) refuse(text, "has no unit", "put it behind the last number, e.g. \"80:10:160 km/h\"");
  const std::string unit = trimmed(std::string_view(parts[2]).substr(end));
  const double from = numberOf(parts[0], text), step = numberOf(parts[1], text);
  const double to = numberOf(trimmed(std::string_view(parts[2]).substr(0, end)), text);
  if (to < from) refuse(text, "ends below its start", "write FROM:STEP:TO UNIT with TO at or above FROM");
  const double steps = std::floor((to - from) / step * (1.0 + 1e-12) + 1e-9);  // the rounding of 0.1, 0.2, ...
  if (!(steps < static_cast<double>(kMostSpeeds))) {
    refuse(text, fmt::format("has more than {} speeds", kMostSpeeds), "take a larger step");
  }
  for (double i = 0.0; i <= steps; ++i) speeds.push_back(speedOf(fmt::format("{:.12g} {}", from + i * step, unit)));
}

}  // namespace

std::vector<double> parseSpeeds(const std::string& text) {
  std::vector<double> speeds;
  for (const std::string& each : partsAt(',', text)) {
    if (each.empty()) refuse(text, "has an empty item", "put one comma between two speeds");
    if (each.find(':') != std::string::npos) {
      addRange(each, speeds);
    } else {
      speeds.push_back(speedOf(each));
    }
  }
  if (speeds.size() > kMostSpeeds) refuse(text, fmt::format("has more than {} speeds", kMostSpeeds), "take fewer");
  std::vector<std::string> names;
  for (const double each : speeds) names.push_back(speedText(each));
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end()) refuse(text, fmt::format("has {} twice", *twice), "give each speed once");
  return speeds;
}

std::string fileAtSpeed(const std::string& file, double speed) {
  const std::filesystem::path path(file);
  const std::string name =
      fmt::format("{}-{:.6g}kmh{}", path.stem().string(), kKilometresPerHour * speed, path.extension().string());
  return (path.parent_path() / name).string();
}

std::vector<std::string> filesAtSpeed(const std::vector<std::string>& files, double speed) {
  std::vector<std::string> named;
  for (const std::string& each : files) named.push_back(fileAtSpeed(each, speed));
  return named;
}

std::string speedText(double speed) { return fmt::format("{:.6g} km/h", kKilometresPerHour * speed); }

}  // namespace vehicle
