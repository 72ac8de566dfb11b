#include "libvehicle/definition/judge.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace vehicle {

namespace {

/// attribute="text" (default)
std::string asInFile(const AttributeText& source) {
  return written(source.written, source.text) + (source.given ? "" : " (default)");
}

}  // namespace

Judge::Judge(ProblemList& problems, std::string_view path, std::string_view name, const Origin& origin)
    : problems_(problems), path_(path), origin_(origin) {
  if (origin.line == 0 && !name.empty()) path_.insert(path_.size() - 1, " name=\"" + std::string(name) + '"');
}

void Judge::say(std::string message, std::string remedy) {
  problems_.add({origin_, path_, std::move(message), std::move(remedy)});
}

void Judge::sayOf(std::string_view attribute, std::string message, std::string remedy) {
  Place place = origin_;
  if (const AttributeText* source = origin_.find(attribute); source != nullptr && source->line > 0) {
    place.line = source->line;
  }
  problems_.add({std::move(place), path_, std::move(message), std::move(remedy)});
}

bool Judge::knows(std::initializer_list<std::string_view> attributes) const {
  return std::all_of(attributes.begin(), attributes.end(), [&](std::string_view each) { return origin_.knows(each); });
}

bool Judge::finite(std::string_view attribute, double value, Dimension dimension) {
  if (!origin_.knows(attribute)) return false;
  if (!std::isfinite(value)) {
    sayOf(attribute, vehicle::written(attribute, std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf"),
          "must be finite");
    return false;
  }
  if (std::abs(value) > kLargest) {
    sayOf(attribute, written(attribute, value, dimension), "must be at most 1e60 in SI units");
    return false;
  }
  return true;
}

bool Judge::positive(std::string_view attribute, double value, Dimension dimension) {
  if (!finite(attribute, value, dimension)) return false;
  if (value <= 0.0) {
    sayOf(attribute, written(attribute, value, dimension), "must be > 0");
  } else if (value < kSmallest) {
    sayOf(attribute, written(attribute, value, dimension), "must be at least 1e-60 in SI units");
  }
  return value >= kSmallest;
}

bool Judge::notNegative(std::string_view attribute, double value, Dimension dimension) {
  if (!finite(attribute, value, dimension)) return false;
  if (value < 0.0) sayOf(attribute, written(attribute, value, dimension), "must be >= 0");
  return value >= 0.0;
}

bool Judge::number(const AttributeRow& row, const void* part) {
  const std::optional<double> value = row.numberIn(part);
  switch (row.sign) {
    case Sign::kPositive:
      return positive(row.name, value, row.dimension);
    case Sign::kNotNegative:
      return notNegative(row.name, value, row.dimension);
    case Sign::kAny:
      break;
  }
  return finite(row.name, value, row.dimension);
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

std::optional<double> Judge::quantity(std::string_view attribute, const std::string& text, Dimension dimension,
                                      const std::string& item) {
  if (!origin_.knows(attribute)) return std::nullopt;
  const bool whole = item.empty() || item == text;
  const ParsedQuantity parsed = parseQuantity(whole ? text : item, dimension);
  if (parsed.si && std::isfinite(*parsed.si)) return parsed.si;
  const std::string place = vehicle::written(attribute, text);
  sayOf(attribute, (whole ? place : place + ": \"" + item + '"') + ' ' + parsed.message, parsed.remedy);
  return std::nullopt;
}

bool Judge::properName(const std::string& name) {
  if (!origin_.knows("name")) return false;
  if (name.empty()) {
    say("has no name", "name=\"...\" is required");
    return false;
  }
  const auto wrong = std::find_if_not(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  if (wrong == name.end()) return true;
  say(vehicle::written("name", name), "a name is made of the letters a-z and A-Z, digits, \"_\" and \"-\"");
  return false;
}

bool Judge::partName(const std::string& name) {
  if (!properName(name)) return false;
  if (name != "scenario" && name != "speed") return true;
  say(vehicle::written("name", name), "the word has a meaning of its own in a study; choose another name");
  return false;
}

std::string Judge::written(std::string_view attribute, double value, Dimension dimension) const {
  // Comparing with the file's text shows whether the value is still the file's.
  const AttributeText* source = origin_.find(attribute);
  if (source != nullptr && parseQuantity(source->text, dimension).si == value) return asInFile(*source);
  return vehicle::written(attribute, value, dimension);
}

std::string Judge::written(std::string_view attribute, int value) const {
  if (const AttributeText* source = origin_.find(attribute); source != nullptr) {
    int said = 0;
    const char* end = source->text.data() + source->text.size();
    const auto [last, error] = std::from_chars(source->text.data(), end, said);
    if (error == std::errc() && last == end && said == value) return asInFile(*source);
  }
  return vehicle::written(attribute, std::to_string(value));
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

std::string andIn(const std::vector<Place>& others) {
  if (others.empty()) return "";
  constexpr std::size_t kMostLines = 8;
  std::string lines;
  for (std::size_t i = 0; i < others.size() && i < kMostLines && others[i].line > 0; ++i) {
    lines += (lines.empty() ? "" : ", ") + std::to_string(others[i].line);
  }
  if (others.size() > kMostLines && !lines.empty()) lines += ", ...";
  return " (and in " + std::to_string(others.size()) + (others.size() == 1 ? " more place" : " more places") +
         (lines.empty() ? ")" : (others.size() == 1 ? ": line " : ": lines ") + lines + ')');
}

}  // namespace vehicle
