#include "libvehicle/units/unit_suggestion.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <utility>
#include <vector>

namespace vehicle {

namespace {

using Words = std::vector<std::string>;

struct Pair {
  std::string_view from;
  std::string_view to;
};

// Words of people who mean one of ours, in lower case.
constexpr std::array kSpellings = {
    Pair{"hr", "h"},         Pair{"hrs", "h"},     Pair{"std", "h"},      Pair{"sec", "s"},     Pair{"secs", "s"},
    Pair{"msec", "ms"},      Pair{"kmh", "km/h"},  Pair{"kph", "km/h"},   Pair{"kmph", "km/h"}, Pair{"mps", "m/s"},
    Pair{"kgs", "kg"},       Pair{"kilo", "kg"},   Pair{"kilos", "kg"},   Pair{"to", "t"},      Pair{"ton", "t"},
    Pair{"tons", "t"},       Pair{"mins", "min"},  Pair{"grad", "deg"},   Pair{"°", "deg"},     Pair{"degs", "deg"},
    Pair{"rads", "rad"},     Pair{"mtr", "m"},     Pair{"mtrs", "m"},     Pair{"cps", "Hz"},    Pair{"hertz", "Hz"},
    Pair{"micron", "um"},    Pair{"microns", "um"}, Pair{"percent", "%"}, Pair{"prozent", "%"}, Pair{"per", "/"}};

constexpr std::array kNames = {Pair{"newton", "N"}, Pair{"meter", "m"},  Pair{"metre", "m"},  Pair{"gram", "g"},
                               Pair{"gramme", "g"}, Pair{"second", "s"}, Pair{"radian", "rad"}, Pair{"tonne", "t"},
                               Pair{"hour", "h"},   Pair{"minute", "min"}, Pair{"degree", "deg"}, Pair{"hertz", "Hz"}};

constexpr std::array kPrefixNames = {Pair{"kilo", "k"},  Pair{"mega", "M"},  Pair{"giga", "G"},
                                     Pair{"milli", "m"}, Pair{"centi", "c"}, Pair{"micro", "u"}};

// In order of preference: what engineers write most often stands first.
constexpr std::array kPrefixes = {"k", "M", "G", "", "m", "c", "d", "u", "n"};
constexpr std::array kSymbols = {"m", "g", "t", "N", "s", "rad", "Hz", "tf", "deg", "min", "h", "%"};

bool isUnit(const std::string& text) { return readUnit(text).unit.has_value(); }

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

/// Every symbol with every prefix it takes.
const Words& allSymbols() {
  static const Words kAll = [] {
    Words all;
    for (const char* symbol : kSymbols) {
      for (const char* prefix : kPrefixes) {
        std::string unit = std::string(prefix) + symbol;
        if (isUnit(unit)) all.push_back(std::move(unit));
      }
    }
    return all;
  }();
  return kAll;
}

bool differByOneLetter(std::string_view a, std::string_view b) {
  if (a.size() < b.size()) std::swap(a, b);
  if (a.size() - b.size() > 1) return false;
  const auto first = std::mismatch(b.begin(), b.end(), a.begin());
  const std::string_view rest_a(first.second, a.end());
  const std::string_view rest_b(first.first, b.end());
  return rest_a.substr(1) == (a.size() == b.size() ? rest_b.substr(std::min<std::size_t>(1, rest_b.size())) : rest_b);
}

/// "kilonewtons" -> "kN"; "" for no such word.
std::string nameToSymbol(std::string word) {
  if (word.size() > 3 && word.back() == 's') word.pop_back();
  const auto symbolOf = [](std::string_view name) {
    const auto found = std::find_if(kNames.begin(), kNames.end(), [&](const Pair& each) { return each.from == name; });
    return found == kNames.end() ? std::string_view() : found->to;
  };
  if (const std::string_view symbol = symbolOf(word); !symbol.empty()) return std::string(symbol);
  for (const auto& [name, prefix] : kPrefixNames) {
    if (!word.starts_with(name)) continue;
    if (const std::string_view symbol = symbolOf(word.substr(name.size())); !symbol.empty()) {
      return std::string(prefix) + std::string(symbol);
    }
  }
  return "";
}

/// What one word of a unit may mean, the likeliest first.
Words meaningsOf(const std::string& word) {
  Words meanings;
  if (isUnit(word)) return {word};
  const std::string lower = lowerCase(word);
  for (const auto& [from, to] : kSpellings) {
    if (lower == from) meanings.emplace_back(to);
  }
  if (std::string symbol = nameToSymbol(lower); !symbol.empty()) meanings.push_back(std::move(symbol));
  for (const std::string& symbol : allSymbols()) {
    if (lowerCase(symbol) == lower) meanings.push_back(symbol);
  }
  // A product without its sign: "kNm", "kNs".
  for (std::size_t cut = 1; cut < word.size() && word.size() <= 8; ++cut) {
    if (isUnit(word.substr(0, cut)) && isUnit(word.substr(cut))) {
      meanings.push_back(word.substr(0, cut) + '*' + word.substr(cut));
    }
  }
  if (word.size() < 2) return meanings;
  for (const std::string& symbol : allSymbols()) {
    if (differByOneLetter(symbol, word)) meanings.push_back(symbol);
  }
  return meanings;
}

bool isLetter(char c) {
  return static_cast<unsigned char>(c) >= 0x80 || c == '%' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// A unit as alternatives for each of its words, with what stands between them put right: spaces and dots multiply,
/// digits behind a word are its power.
class Alternatives {
 public:
  explicit Alternatives(std::string_view text) {
    const std::string plain = replaced(text);
    for (std::size_t i = 0; i < plain.size();) i = isLetter(plain[i]) ? addWord(plain, i) : addSign(plain, i);
  }

  [[nodiscard]] const std::vector<Words>& pieces() const { return pieces_; }

 private:
  static std::string replaced(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size();) {
      const auto found = std::find_if(kSigns.begin(), kSigns.end(),
                                      [&](const Pair& each) { return text.substr(i).starts_with(each.from); });
      if (found == kSigns.end()) {
        plain += text[i++];
      } else {
        plain += found->to;
        i += found->from.size();
      }
    }
    return plain;
  }

  std::size_t addWord(const std::string& text, std::size_t begin) {
    std::size_t end = begin;
    while (end < text.size() && isLetter(text[end])) ++end;
    Words meanings = meaningsOf(text.substr(begin, end - begin));
    const bool divides = meanings == Words{"/"};
    if (after_factor_ && !divides) pieces_.push_back({"*"});
    pieces_.push_back(std::move(meanings));
    after_factor_ = !divides;
    // "m/s2"
    if (end < text.size() && text[end] >= '0' && text[end] <= '9') pieces_.push_back({"^"});
    return end;
  }

  std::size_t addSign(const std::string& text, std::size_t i) {
    const char c = text[i];
    const bool before_letter = i + 1 < text.size() && isLetter(text[i + 1]);
    if (c == ' ' || c == '\t') return i + 1;  // what multiplies is added before the next factor
    const bool multiplies = c == '*' || ((c == '.' || c == '-') && before_letter && after_factor_);
    pieces_.push_back({multiplies ? "*" : std::string(1, c)});
    if (c == '^') {
      // The power with its sign and digits.
      for (++i; i < text.size() && (text[i] == '-' || text[i] == '.' || (text[i] >= '0' && text[i] <= '9')); ++i) {
        pieces_.push_back({std::string(1, text[i])});
      }
      return i;
    }
    if (multiplies || c == '/' || c == '(') after_factor_ = false;
    if (c == ')') after_factor_ = true;
    return i + 1;
  }

  static constexpr std::array<Pair, 6> kSigns = {{{"\u00b7", "*"}, {"\u22c5", "*"}, {"\u00d7", "*"}, {"\u00b2", "^2"},
                                                  {"\u00b3", "^3"}, {"**", "^"}}};
  std::vector<Words> pieces_;
  bool after_factor_ = false;
};

// Units that are not read, each with one that is.
struct Foreign {
  std::string_view word;
  std::string_view ours;
  std::string_view note;
};
constexpr std::array kForeign = {
    Foreign{"mph", "m/s", "1 mph = 1.609344 km/h"},      Foreign{"kgf", "N", "1 kgf = 9.80665 N"},
    Foreign{"kp", "N", "1 kp = 9.80665 N"},              Foreign{"dan", "N", "1 daN = 10 N"},
    Foreign{"gon", "rad", "1 gon = 0.9 deg"},            Foreign{"rpm", "rad/s", "1 rpm = 6 deg/s"},
    Foreign{"lb", "kg", "1 lb = 0.45359237 kg"},         Foreign{"lbs", "kg", "1 lb = 0.45359237 kg"},
    Foreign{"lbf", "N", "1 lbf = 4.4482216152605 N"},    Foreign{"in", "m", "1 in = 25.4 mm"},
    Foreign{"inch", "m", "1 in = 25.4 mm"},              Foreign{"ft", "m", "1 ft = 304.8 mm"}};

}  // namespace

std::optional<std::string> suggestUnit(std::string_view text, const std::function<bool(const BaseUnits&)>& fits) {
  constexpr std::size_t kLongest = 32;
  constexpr int kMostTries = 2000;
  if (text.size() > kLongest) return std::nullopt;
  const Alternatives alternatives(text);
  const std::vector<Words>& pieces = alternatives.pieces();
  if (std::any_of(pieces.begin(), pieces.end(), [](const Words& each) { return each.empty(); })) return std::nullopt;
  // Counts through all combinations, the last piece fastest.
  std::vector<std::size_t> choice(pieces.size(), 0);
  for (int tries = 0; tries < kMostTries; ++tries) {
    std::string unit;
    for (std::size_t i = 0; i < pieces.size(); ++i) unit += pieces[i][choice[i]];
    const UnitReading reading = readUnit(unit);
    if (!unit.empty() && reading.unit && fits(reading.unit->base)) return unit;
    std::size_t place = pieces.size();
    while (place > 0 && choice[place - 1] + 1 == pieces[place - 1].size()) choice[--place] = 0;
    if (place == 0) break;
    ++choice[place - 1];
  }
  return std::nullopt;
}

std::string conversionOf(std::string_view text, const std::function<bool(const BaseUnits&)>& fits) {
  for (const auto& [word, ours, note] : kForeign) {
    const std::string lower = lowerCase(text);
    const std::size_t at = lower.find(word);
    const bool whole = at != std::string::npos && (at == 0 || !isLetter(lower[at - 1])) &&
                       (at + word.size() == lower.size() || !isLetter(lower[at + word.size()]));
    if (!whole) continue;
    const std::string in_ours = std::string(text.substr(0, at)) + '(' + std::string(ours) + ')' +
                                std::string(text.substr(at + word.size()));
    const UnitReading reading = readUnit(in_ours);
    if (reading.unit && fits(reading.unit->base)) return std::string(note);
  }
  return "";
}

}  // namespace vehicle
