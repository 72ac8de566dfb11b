#include "libvehicle/definition/judge.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vehicle {

Judge::Judge(ProblemList& problems, std::string_view path, std::string_view name, const Place& place)
    : problems_(problems), path_(path), place_(place) {
  if (place.line == 0 && !name.empty()) path_.insert(path_.size() - 1, " name=\"" + std::string(name) + '"');
}

void Judge::say(std::string message, std::string remedy) {
  problems_.add({place_, path_, std::move(message), std::move(remedy)});
}

bool Judge::finite(std::string_view attribute, double value, Dimension dimension) {
  if (!std::isfinite(value)) {
    say(written(attribute, std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf"), "must be finite");
    return false;
  }
  if (std::abs(value) > kLargest) {
    say(written(attribute, value, dimension), "must be at most 1e60 in SI units");
    return false;
  }
  return true;
}

bool Judge::positive(std::string_view attribute, double value, Dimension dimension) {
  if (!finite(attribute, value, dimension)) return false;
  if (value <= 0.0) {
    say(written(attribute, value, dimension), "must be > 0");
  } else if (value < kSmallest) {
    say(written(attribute, value, dimension), "must be at least 1e-60 in SI units");
  }
  return value >= kSmallest;
}

bool Judge::notNegative(std::string_view attribute, double value, Dimension dimension) {
  if (!finite(attribute, value, dimension)) return false;
  if (value < 0.0) say(written(attribute, value, dimension), "must be >= 0");
  return value >= 0.0;
}

bool Judge::finite(std::string_view attribute, std::optional<double> value, Dimension dimension) {
  return !value || finite(attribute, *value, dimension);
}

bool Judge::positive(std::string_view attribute, std::optional<double> value, Dimension dimension) {
  return !value || positive(attribute, *value, dimension);
}

bool Judge::notNegative(std::string_view attribute, std::optional<double> value, Dimension dimension) {
  return !value || notNegative(attribute, *value, dimension);
}

std::optional<double> Judge::quantity(std::string_view attribute, const std::string& text, Dimension dimension) {
  const ParsedQuantity parsed = parseQuantity(text, dimension);
  if (parsed.si && std::isfinite(*parsed.si)) return parsed.si;
  say(written(attribute, text) + ' ' + parsed.message, parsed.remedy);
  return std::nullopt;
}

bool Judge::properName(const std::string& name) {
  if (name.empty()) {
    say("has no name", "name=\"...\" is required");
    return false;
  }
  const auto wrong = std::find_if_not(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  if (wrong == name.end()) return true;
  say(written("name", name), "a name is made of the letters a-z and A-Z, digits, \"_\" and \"-\"");
  return false;
}

bool Judge::partName(const std::string& name) {
  if (!properName(name)) return false;
  if (name != "scenario" && name != "speed") return true;
  say(written("name", name), "the word has a meaning of its own in a study; choose another name");
  return false;
}

std::string written(std::string_view attribute, double value, Dimension dimension) {
  return written(attribute, formatQuantity(value, dimension));
}

std::string written(std::string_view attribute, std::string_view text) {
  std::string one_line(text);
  std::replace_if(one_line.begin(), one_line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return std::string(attribute) + "=\"" + one_line + '"';
}

std::string inLine(const Place& place) {
  return place.line > 0 ? " (line " + std::to_string(place.line) + ')' : "";
}

}  // namespace vehicle
