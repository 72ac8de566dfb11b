#include "libvehicle/report/trace/timeline.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/storage/output_kind.h"
#include "libvehicle/xml/escape.h"

namespace vehicle::report {
namespace {

constexpr double kWidth = 1040.0, kLeft = 96.0, kRight = 28.0;  // [px]
constexpr double kLane = 24.0, kGap = 8.0, kHead = 84.0, kPanelHead = 30.0, kAxis = 46.0;
constexpr const char* kCompute = "#2c6fbb";
constexpr const char* kWait = "#f3c268";
constexpr const char* kUntraced = "#eeeeee";

struct Step {
  long number = 0;
  double begin = 0.0;  // [s]
  double end = 0.0;    // [s]
  [[nodiscard]] double duration() const { return end - begin; }
};

/// The traced steps of member 0, the shortest first.
std::vector<Step> stepsOf(const Trace& trace) {
  std::vector<Step> steps;
  for (const Span& span : trace.spans) {
    if (span.thread != 0) continue;
    if (steps.empty() || steps.back().number != span.step) steps.push_back({span.step, span.begin_s, span.end_s});
    steps.back().end = span.end_s;
  }
  std::ranges::stable_sort(steps, {}, &Step::duration);
  return steps;
}

std::string textAt(double x, double y, const char* style, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, style, xmlEscaped(text));
}

std::string box(double x, double y, double width, double height, const char* colour, const std::string& tip) {
  return fmt::format(
      "<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\" fill=\"{}\"><title>{}</title></rect>\n", x, y,
      width, height, colour, xmlEscaped(tip));
}

/// 1, 2 or 5 times a power of ten, so that about eight ticks stand on the axis.
double tickOf(double length) {
  const double rough = length / 8.0;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10.0 * power;
}

std::string axis(double y, double length_us) {
  const double scale = (kWidth - kLeft - kRight) / length_us;
  std::string text = fmt::format("<path d=\"M{0:.1f} {1:.1f}H{2:.1f}\" stroke=\"#555\"/>\n", kLeft, y, kWidth - kRight);
  const double tick = tickOf(length_us);
  for (double t = 0.0; t <= length_us * (1.0 + 1e-9); t += tick) {
    const double x = kLeft + scale * t;
    text += fmt::format("<path d=\"M{0:.1f} {1:.1f}v5\" stroke=\"#555\"/>\n", x, y);
    text += textAt(x, y + 19.0, "text-anchor=\"middle\"", fmt::format("{:.6g}", t + 0.0));
  }
  return text + textAt(kWidth - kRight, y + 36.0, "text-anchor=\"end\"", "time since the step began [us]");
}

std::string laneBox(const Span& span, const Step& step, double y, double scale) {
  const double from = std::max(span.begin_s, step.begin);
  const double to = std::min(span.end_s, step.end);
  if (!(to > from)) return {};
  const double x = kLeft + scale * (from - step.begin);
  const double width = scale * (to - from);
  const bool waits = span.kind == Span::Kind::kWait;
  const std::string what = waits ? fmt::format("waits for thread {}", span.for_whom + 1) : "computes";
  std::string text = box(x, y, width, kLane, waits ? kWait : kCompute,
                         fmt::format("thread {}, step {}: {}, {:.3f} us", span.thread + 1, span.step, what,
                                     1e6 * (span.end_s - span.begin_s)));
  constexpr double kRoomForALabel = 34.0;
  if (waits && width >= kRoomForALabel) {
    text += textAt(x + width / 2.0, y + 16.0, "text-anchor=\"middle\" font-size=\"11\"",
                   fmt::format("for {}", span.for_whom + 1));
  }
  return text;
}

std::string panel(const Trace& trace, const Step& step, double top, const char* name) {
  const double scale = (kWidth - kLeft - kRight) / step.duration();
  std::string text = textAt(kLeft, top + 18.0, "font-weight=\"bold\"",
                            fmt::format("{}: step {}, {:.5g} us", name, step.number, 1e6 * step.duration()));
  const auto laneTop = [&](int thread) { return top + kPanelHead + thread * (kLane + kGap); };
  for (int i = 0; i < trace.threads; ++i) {
    text += textAt(kLeft - 10.0, laneTop(i) + 16.0, "text-anchor=\"end\"", fmt::format("thread {}", i + 1));
    text += box(kLeft, laneTop(i), kWidth - kLeft - kRight, kLane, kUntraced,
                fmt::format("thread {}: not traced here", i + 1));
  }
  for (const Span& span : trace.spans) text += laneBox(span, step, laneTop(span.thread), scale);
  return text + axis(laneTop(trace.threads), 1e6 * step.duration());
}

std::string legend() {
  std::string text;
  double x = kLeft;
  for (const auto& [colour, word] : {std::pair{kCompute, "computing"}, std::pair{kWait, "waiting for thread n"},
                                     std::pair{kUntraced, "not traced"}}) {
    text += box(x, 54.0, 16.0, 14.0, colour, word);
    text += textAt(x + 22.0, 66.0, "", word);
    x += 170.0;
  }
  return text;
}

}  // namespace

std::string timelineOf(const Trace& trace, const std::string& title) {
  const std::vector<Step> steps = stepsOf(trace);
  const bool drawable = !steps.empty() && steps.back().duration() > 0.0;
  const double panel_height = kPanelHead + trace.threads * (kLane + kGap) + kAxis + 14.0;
  const double height = kHead + (drawable ? 2.0 * panel_height : 30.0);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"13\" fill=\"#222\">\n"
      "{2}\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      kWidth, height, kTimelineMark);
  text += textAt(kLeft, 34.0, "font-size=\"17\" font-weight=\"bold\"", title) + legend();
  if (!drawable) return text + textAt(kLeft, kHead + 18.0, "", "no step was traced") + "</svg>\n";
  text += panel(trace, steps[steps.size() / 2], kHead, "a step of median length");
  text += panel(trace, steps.back(), kHead + panel_height, "the longest traced step");
  return text + "</svg>\n";
}

}  // namespace vehicle::report
