#include "libvehicle/xml/attribute_value.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/xml/message_text.h"

namespace vehicle {

namespace {

constexpr std::string_view kSpaces = " \t\r\n";

bool isLetterOrDigit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

constexpr std::size_t kLongestName = 64;

bool isName(std::string_view text, std::size_t longest = kLongestName) {
  return !text.empty() && text.size() <= longest && isLetterOrDigit(text.front()) &&
         std::all_of(text.begin(), text.end(), [](char c) { return isLetterOrDigit(c) || c == '_' || c == '-'; });
}

std::string written(const AttributeRow& row, std::string_view text) {
  return fmt::format("{}=\"{}\"", row.name, shown(text));
}

std::string listed(const Words& choices) { return fmt::format("\"{}\"", joined(choices.strings(), "\", \"")); }

std::string chooseRemedy(std::string_view word, const Words& choices) {
  if (const auto nearest = suggestion(word, choices.strings())) return fmt::format("did you mean \"{}\"?", *nearest);
  return "write one of these";
}

int indexOf(std::string_view word, const Words& choices) {
  const auto found = std::find(choices.begin(), choices.end(), word);
  return found == choices.end() ? -1 : static_cast<int>(found - choices.begin());
}

/// A part of a train is called after its vehicle, which is called after its file and its number.
bool isPartOfTrain(std::string_view text) {
  constexpr std::size_t kLongestNumber = 6;  // "_10000"
  const std::size_t dot = text.find('.');
  return dot != std::string_view::npos && isName(text.substr(0, dot), kLongestName + kLongestNumber) &&
         isName(text.substr(dot + 1));
}

AttributeReading readName(const AttributeRow& row, std::string_view text) {
  if (isName(text) || (row.kind == ValueKind::kReference && isPartOfTrain(text))) return {std::string(text), "", ""};
  return {std::string(text), fmt::format("{} is no name", written(row, text)),
          fmt::format("names have up to {} letters a-z, A-Z, digits, \"_\" and \"-\", and begin with a letter or digit",
                      kLongestName)};
}

AttributeReading readFile(const AttributeRow& row, std::string_view text) {
  if (text.find_first_not_of(kSpaces) != std::string_view::npos) return {std::string(text), "", ""};
  return {std::string(text), fmt::format("{} names no file", written(row, text)),
          "write the path of one, counted from the folder of this file"};
}

AttributeReading readWords(const AttributeRow& row, std::string_view text) {
  if (text.find_first_not_of(kSpaces) != std::string_view::npos) return {std::string(text), "", ""};
  return {std::string(text), fmt::format("{} is empty", written(row, text)),
          "write what it says, or leave the attribute out"};
}

AttributeReading readQuantity(const AttributeRow& row, std::string_view text) {
  const ParsedQuantity parsed = parseQuantity(text, row.dimension);
  if (!parsed.si || !std::isfinite(*parsed.si)) {
    return {standInFor(row), fmt::format("{} {}", written(row, text), parsed.message), parsed.remedy};
  }
  const bool in_range =
      row.sign == Sign::kAny || *parsed.si > 0.0 || (row.sign == Sign::kNotNegative && *parsed.si == 0.0);
  if (!in_range) return {standInFor(row), written(row, text), fmt::format("must be {}", rangeOf(row))};
  return {*parsed.si, "", ""};
}

AttributeReading readInteger(const AttributeRow& row, std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error != std::errc::invalid_argument && end == text.data() + text.size();
  if (!whole) {
    return {row.least, fmt::format("{} is no whole number", written(row, text)),
            fmt::format("must be from {}", rangeOf(row))};
  }
  if (error == std::errc::result_out_of_range || number < row.least || number > row.most) {
    return {row.least, written(row, text), fmt::format("must be from {}", rangeOf(row))};
  }
  return {number, "", ""};
}

AttributeReading readChoice(const AttributeRow& row, std::string_view text) {
  for (const Words* words : {&row.choices, &row.spellings}) {
    if (const int index = indexOf(text, *words); index >= 0) return {index, "", ""};
  }
  const auto nearest = suggestion(text, row.choices.strings());
  return {nearest ? indexOf(*nearest, row.choices) : 0,
          fmt::format("{} is none of {}", written(row, text), listed(row.choices)), chooseRemedy(text, row.choices)};
}

AttributeReading readChoiceList(const AttributeRow& row, std::string_view text) {
  AttributeReading reading;
  std::vector<int> indices;
  for (std::size_t at = text.find_first_not_of(kSpaces); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSpaces, at), text.size());
    const std::string_view word = text.substr(at, end - at);
    at = text.find_first_not_of(kSpaces, end);
    const int index = indexOf(word, row.choices);
    const bool repeated = std::find(indices.begin(), indices.end(), index) != indices.end();
    if (index >= 0 && !repeated) {
      indices.push_back(index);
    } else if (reading.message.empty()) {
      reading.message =
          index >= 0 ? fmt::format("{}: \"{}\" stands twice", written(row, text), shown(word))
                     : fmt::format("{}: \"{}\" is none of {}", written(row, text), shown(word), listed(row.choices));
      reading.remedy = index >= 0 ? "write it once" : chooseRemedy(word, row.choices);
    }
  }
  if (indices.empty() && reading.message.empty()) {
    reading.message = fmt::format("{} is empty", written(row, text));
    reading.remedy = fmt::format("write one or more of {}", listed(row.choices));
  }
  // "z" moves without asking for anything else (pitch would want its inertia).
  if (indices.empty()) indices.push_back(std::max(0, indexOf("z", row.choices)));
  reading.value = indices;
  return reading;
}

}  // namespace

Value standInFor(const AttributeRow& row) {
  switch (row.kind) {
    // Nothing as far as that is allowed: a phase of 0 makes no jump, a mass must be something.
    case ValueKind::kQuantity:
      return row.sign == Sign::kPositive ? 1.0 : 0.0;
    case ValueKind::kInteger:
      return row.least;
    case ValueKind::kChoice:
      return 0;
    case ValueKind::kChoiceList:
      return readChoiceList(row, "").value;
    case ValueKind::kFile:
      return "file.xml";
    default:
      return {};
  }
}

AttributeReading readAttribute(const AttributeRow& row, std::string_view text) {
  switch (row.kind) {
    case ValueKind::kName:
    case ValueKind::kReference:
      return readName(row, text);
    case ValueKind::kFile:
      return readFile(row, text);
    case ValueKind::kText:
      return readWords(row, text);
    case ValueKind::kQuantity:
      return readQuantity(row, text);
    case ValueKind::kInteger:
      return readInteger(row, text);
    case ValueKind::kChoice:
      return readChoice(row, text);
    case ValueKind::kChoiceList:
      return readChoiceList(row, text);
    case ValueKind::kFormat:
      break;
  }
  if (text == kFileFormat) return {};
  return {{},
          fmt::format("{} is unknown to this program", written(row, text)),
          fmt::format("it reads format=\"{}\"", kFileFormat)};
}

std::string attributeText(const AttributeRow& row, const Value& value) {
  switch (row.kind) {
    case ValueKind::kFormat:
      return std::string(kFileFormat);
    case ValueKind::kName:
    case ValueKind::kReference:
    case ValueKind::kFile:
    case ValueKind::kText:
      return std::get<std::string>(value);
    case ValueKind::kInteger:
      return std::to_string(std::get<int>(value));
    case ValueKind::kChoice:
      return std::string(row.choices[static_cast<std::size_t>(std::get<int>(value))]);
    case ValueKind::kQuantity:
      break;
    case ValueKind::kChoiceList: {
      std::vector<std::string> words;
      for (const int index : std::get<std::vector<int>>(value)) {
        words.emplace_back(row.choices[static_cast<std::size_t>(index)]);
      }
      return joined(words, " ");
    }
  }
  const double si = std::get<double>(value);
  if (!std::isfinite(si)) throw std::invalid_argument(fmt::format("write: {} = {}, must be finite", row.name, si));
  return formatQuantity(si, row.dimension);
}

std::optional<std::string> suggestion(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t kShortestWord = 3;  // "y" is no mistyped "x"
  constexpr std::size_t kLongestWord = 64;
  if (word.size() < kShortestWord || word.size() > kLongestWord) return std::nullopt;
  return nearestName(std::string(word), candidates);
}

}  // namespace vehicle
