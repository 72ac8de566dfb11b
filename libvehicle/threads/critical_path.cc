#include "libvehicle/threads/critical_path.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace vehicle {

namespace {

using Lane = std::vector<Span>;  // of one thread, by time

std::vector<Lane> lanesOf(const Trace& trace) {
  std::vector<Lane> lanes(static_cast<std::size_t>(std::max(trace.threads, 0)));
  for (const Span& span : trace.spans) lanes[static_cast<std::size_t>(span.thread)].push_back(span);
  return lanes;
}

/// The span that lasts up to t or beyond and begins before it, if that thread was traced then.
const Span* spanBefore(const Lane& lane, double t) {
  const auto after = std::ranges::lower_bound(lane, t, {}, &Span::begin_s);
  if (after == lane.begin()) return nullptr;
  const Span& found = *(after - 1);
  return found.end_s >= t ? &found : nullptr;
}

class Walk {
 public:
  explicit Walk(const Trace& trace) : lanes_(lanesOf(trace)) { path_.computing.resize(lanes_.size()); }

  CriticalPath run() {
    if (lanes_.empty()) return std::move(path_);
    const Lane& first = lanes_.front();
    for (std::size_t begin = 0; begin < first.size();) {
      std::size_t end = begin + 1;
      while (end < first.size() && first[end].step == first[begin].step) ++end;
      back(first[begin].begin_s, first[end - 1].end_s);
      ++path_.steps;
      begin = end;
    }
    for (const auto& [pair, count] : handovers_) path_.handovers.push_back({pair.first, pair.second, count});
    std::ranges::stable_sort(path_.handovers, std::ranges::greater{}, &CriticalPath::HandOver::count);
    return std::move(path_);
  }

 private:
  void back(double begin, double end) {
    path_.seconds += end - begin;
    int thread = 0;
    double t = end;
    while (t > begin) {
      const Span* span = spanBefore(lanes_[static_cast<std::size_t>(thread)], t);
      if (span == nullptr) {
        // Nothing was traced there then: the thread that was waited for had its own work, whatever it was.
        path_.computing[static_cast<std::size_t>(thread)] += t - begin;
        return;
      }
      const double from = std::max(span->begin_s, begin);
      if (span->kind == Span::Kind::kCompute) {
        path_.computing[static_cast<std::size_t>(thread)] += t - from;
        t = from;
        continue;
      }
      const double shown = std::max(shownAt(*span, t), from);
      path_.delivery += t - shown;
      if (shown > from) {
        ++handovers_[{span->for_whom, thread}];
        thread = span->for_whom;
      }
      t = shown;
    }
  }

  // When the thread that is waited for had shown its values: as it turned to waiting itself, else at the wait's end.
  [[nodiscard]] double shownAt(const Span& wait, double t) const {
    if (wait.for_whom < 0 || wait.for_whom >= static_cast<int>(lanes_.size())) return wait.begin_s;
    const Span* other = spanBefore(lanes_[static_cast<std::size_t>(wait.for_whom)], t);
    if (other == nullptr) return wait.begin_s;
    return other->kind == Span::Kind::kCompute ? t : other->begin_s;
  }

  std::vector<Lane> lanes_;
  CriticalPath path_;
  std::map<std::pair<int, int>, long> handovers_;
};

}  // namespace

CriticalPath criticalPathOf(const Trace& trace) { return Walk(trace).run(); }

}  // namespace vehicle
