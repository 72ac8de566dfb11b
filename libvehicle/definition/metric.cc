#include "libvehicle/definition/metric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/units/quantity.h"

namespace vehicle {

namespace {

struct Word {
  std::string_view name;
  Statistic statistic;
};
constexpr std::array<Word, 5> kWords = {{{"rms", Statistic::kRms},
                                         {"mean", Statistic::kMean},
                                         {"peak", Statistic::kPeak},
                                         {"min", Statistic::kMin},
                                         {"max", Statistic::kMax}}};

constexpr const char* kGrammar =
    "end it in .rms, .mean, .peak, .min, .max, .p99.85, .abs_p95 or .band(4..8 Hz); or write mode.NAME.frequency, "
    "mode.NAME.damped_frequency, mode.NAME.undamped_frequency, mode.NAME.damping, static.NAME.deflection or "
    "static.NAME.load";

constexpr std::array<std::string_view, 4> kOfModes = {"frequency", "damped_frequency", "undamped_frequency", "damping"};
constexpr std::array<std::string_view, 2> kAtRest = {"deflection", "load"};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpaces = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kSpaces);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kSpaces) - begin + 1);
}

ParsedMetric refuse(std::string message, std::string remedy) {
  return {std::nullopt, std::move(message), std::move(remedy)};
}

/// SUBJECT of `prefix`SUBJECT`.word`; an empty subject is none.
std::optional<std::string> between(std::string_view text, std::string_view prefix, std::string_view word) {
  if (text.size() < prefix.size() + word.size() + 2 || !text.starts_with(prefix) || !text.ends_with(word)) return {};
  text.remove_suffix(word.size());
  if (text.back() != '.') return {};
  return std::string(text.substr(prefix.size(), text.size() - prefix.size() - 1));
}

ParsedMetric asked(Metric metric, MetricKind kind, const std::string& subject, std::string_view quantity) {
  metric.kind = kind;
  metric.subject = subject;
  metric.quantity = quantity;
  return {std::move(metric), "", ""};
}

std::optional<double> plainNumber(std::string_view text) {
  if (text.empty() || text.find_first_not_of("0123456789.") != std::string_view::npos) return {};
  return parseQuantity(text, Dimension::kNumber).si;
}

ParsedMetric band(Metric metric, std::string_view inside) {
  constexpr const char* kExample = "a band has two frequencies, e.g. carbody.az.band(4..8 Hz)";
  const std::size_t dots = inside.find("..");
  if (dots == std::string_view::npos) return refuse("has a band without \"..\"", kExample);
  const std::string_view low = trimmed(inside.substr(0, dots));
  const std::string_view high = trimmed(inside.substr(dots + 2));
  const ParsedQuantity to = parseQuantity(high, Dimension::kFrequency);
  // "4..8 Hz": the unit at the end serves both.
  ParsedQuantity from = parseQuantity(low, Dimension::kFrequency);
  if (!from.si && plainNumber(low)) {
    const std::size_t unit = high.find_first_not_of("0123456789.eE+- ");
    if (unit != std::string_view::npos) {
      from = parseQuantity(std::string(low) + ' ' + std::string(high.substr(unit)), Dimension::kFrequency);
    }
  }
  if (!to.si) return refuse("has a band up to \"" + std::string(high) + "\", which " + to.message, kExample);
  if (!from.si) return refuse("has a band from \"" + std::string(low) + "\", which " + from.message, kExample);
  if (!std::isfinite(*to.si) || *from.si < 0.0 || *from.si >= *to.si) {
    return refuse("has a band from " + formatQuantity(*from.si, Dimension::kFrequency) + " to " +
                      formatQuantity(*to.si, Dimension::kFrequency),
                  "a band goes from the lower to the higher, from 0 Hz on");
  }
  metric.statistic = Statistic::kBand;
  metric.low = *from.si;
  metric.high = *to.si;
  return {std::move(metric), "", ""};
}

/// "COLUMN.p99.85" or "COLUMN.abs_p95"; nothing if the text is no percentile at all.
std::optional<ParsedMetric> percentile(Metric metric, std::string_view text) {
  for (const auto& [mark, statistic] : {std::pair<std::string_view, Statistic>{".p", Statistic::kPercentile},
                                        {".abs_p", Statistic::kAbsolutePercentile}}) {
    const std::size_t at = text.rfind(mark);
    if (at == std::string_view::npos || at == 0) continue;
    const std::optional<double> percent = plainNumber(text.substr(at + mark.size()));
    if (!percent) continue;
    if (*percent <= 0.0 || *percent >= 100.0) {
      return refuse("asks for a percentile outside 0 to 100", "write e.g. .p99.85; the ends are .min and .max");
    }
    metric.subject = text.substr(0, at);
    metric.statistic = statistic;
    metric.percent = *percent;
    return ParsedMetric{std::move(metric), "", ""};
  }
  return std::nullopt;
}

}  // namespace

ParsedMetric parseMetric(std::string_view raw) {
  const std::string_view text = trimmed(raw);
  Metric metric;
  metric.name = text;
  for (const std::string_view quantity : kOfModes) {
    if (const auto subject = between(text, "mode.", quantity))
      return asked(metric, MetricKind::kMode, *subject, quantity);
  }
  for (const std::string_view quantity : kAtRest) {
    if (const auto subject = between(text, "static.", quantity)) {
      return asked(metric, MetricKind::kStatic, *subject, quantity);
    }
  }
  if (const std::size_t open = text.rfind(".band("); open != std::string_view::npos && open > 0 && text.back() == ')') {
    metric.subject = text.substr(0, open);
    return band(std::move(metric), text.substr(open + 6, text.size() - open - 7));
  }
  if (auto parsed = percentile(metric, text)) return std::move(*parsed);
  const std::size_t dot = text.rfind('.');
  const std::string last(dot == std::string_view::npos ? text : text.substr(dot + 1));
  std::vector<std::string> words;
  for (const Word& word : kWords) {
    words.emplace_back(word.name);
    if (last != word.name || dot == std::string_view::npos || dot == 0) continue;
    metric.subject = text.substr(0, dot);
    metric.statistic = word.statistic;
    return {std::move(metric), "", ""};
  }
  if (text.starts_with("mode.")) words.insert(words.end(), kOfModes.begin(), kOfModes.end());
  if (text.starts_with("static.")) words.insert(words.end(), kAtRest.begin(), kAtRest.end());
  if (const auto nearest = nearestName(last, words); nearest && dot != std::string_view::npos && dot > 0) {
    return refuse("ends in \"" + last + "\", which is no statistic", "did you mean \"" + *nearest + "\"?");
  }
  return refuse("ends in no statistic", kGrammar);
}

std::string unitOf(const Metric& metric, std::string_view column_unit) {
  if (metric.kind == MetricKind::kColumn) return std::string(column_unit);
  if (metric.quantity.ends_with("frequency")) return "Hz";
  if (metric.quantity == "deflection") return "m";
  return metric.quantity == "load" ? "N" : "";
}

}  // namespace vehicle
