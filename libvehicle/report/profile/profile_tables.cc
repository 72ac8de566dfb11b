#include "libvehicle/report/profile/profile_tables.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/report/run/sharing_tables.h"
#include "libvehicle/threads/critical_path.h"

namespace vehicle::report {
namespace {

Cell known(long value) { return value < 0 ? Cell() : Cell(value); }
/// [%]; nothing where the part is not known or there is no whole.
Cell shareOf(double part, double whole) { return part >= 0.0 && whole > 0.0 ? Cell(100.0 * part / whole) : Cell(); }
Cell orNothing(const std::string& text) { return text.empty() ? Cell() : Cell(text); }

std::string wordsOf(const Waiting& waiting) {
  if (waiting.pauses == Waiting::kForever) return "pause without end";
  std::string text = waiting.pauses > 0 ? fmt::format("pause {} times, then ", waiting.pauses) : "";
  if (waiting.yields == Waiting::kForever) return text + "yield without end";
  if (waiting.yields > 0) text += fmt::format("yield {} times, then ", waiting.yields);
  return text + fmt::format("sleep {:.3g} us a time", 1e6 * waiting.sleep);
}

Table speedTable(const Profile& profile) {
  Table table{"time of a step",
              {{"run", ""}, {"threads", ""}, {"median", "ns"}, {"least", "ns"}, {"runs", ""}, {"speed-up", ""}},
              {}};
  const double serial = profile.serial.median();
  const auto add = [&](const std::string& name, int threads, const StepTimes& times) {
    const double median = times.median();
    table.rows.push_back({name, static_cast<long>(threads), 1e9 * median, 1e9 * times.least(),
                          static_cast<long>(times.seconds.size()), median > 0.0 ? Cell(serial / median) : Cell()});
  };
  add(fmt::format("{}, best serial code", profile.run.method), 1, profile.serial);
  add(profile.run.scheme, profile.run.threads, profile.plain);
  add(fmt::format("{}, every {}th step traced", profile.run.scheme, profile.trace.every), profile.run.threads,
      profile.traced);
  return table;
}

Table shareTable(const Profile& profile) {
  Table table{"threads",
              {{"thread", ""},
               {"computing", "%"},
               {"waiting", "%"},
               {"on a core", "%"},
               {"preempted", "%"},
               {"I/O", "%"},
               {"asleep", "%"}},
              {}};
  const std::size_t threads = profile.run.team.members.size();
  std::vector<double> computing(threads), waiting(threads);
  for (const Span& span : profile.trace.spans) {
    (span.kind == Span::Kind::kWait ? waiting : computing)[static_cast<std::size_t>(span.thread)] +=
        span.end_s - span.begin_s;
  }
  for (std::size_t i = 0; i < threads; ++i) {
    const ThreadUsage& usage = profile.run.team.members[i].usage;
    const double traced = computing[i] + waiting[i];
    const double elsewhere = usage.running + usage.preempted + std::max(0.0, usage.blocked_io);
    const bool known_all = usage.running >= 0.0 && usage.preempted >= 0.0;
    std::vector<Cell> row = {static_cast<long>(i + 1)};
    row.push_back(shareOf(computing[i], traced));
    row.push_back(shareOf(waiting[i], traced));
    row.push_back(shareOf(usage.running, usage.wall));
    row.push_back(shareOf(usage.preempted, usage.wall));
    row.push_back(shareOf(usage.blocked_io, usage.wall));
    row.push_back(shareOf(known_all ? std::max(0.0, usage.wall - elsewhere) : -1.0, usage.wall));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table workTable(const RunResult& run) {
  Table table{"who computes what", {{"thread", ""}, {"equations", ""}, {"which", ""}}, {}};
  for (std::size_t i = 0; i < run.work.size(); ++i) {
    table.rows.push_back({static_cast<long>(i + 1), static_cast<long>(run.work[i].equations), run.work[i].what});
  }
  return table;
}

Table waitTable(const Trace& trace) {
  Table table{"who waited for whom, in the traced steps",
              {{"thread", ""}, {"for thread", ""}, {"waits", ""}, {"together", "us"}, {"mean", "ns"}},
              {},
              2};
  for (const WaitTotal& each : trace.waits) {
    table.rows.push_back({static_cast<long>(each.thread + 1), static_cast<long>(each.for_whom + 1), each.count,
                          1e6 * each.seconds, 1e9 * each.seconds / static_cast<double>(each.count)});
  }
  return table;
}

Table pathTable(const Trace& trace) {
  Table table{"critical path of the traced steps", {{"what", ""}, {"mean of a step", "ns"}, {"share", "%"}}, {}};
  const CriticalPath path = criticalPathOf(trace);
  if (path.steps == 0 || !(path.seconds > 0.0)) return table;
  const auto add = [&](const std::string& what, double seconds) {
    table.rows.push_back({what, 1e9 * seconds / static_cast<double>(path.steps), 100.0 * seconds / path.seconds});
  };
  for (std::size_t i = 0; i < path.computing.size(); ++i) {
    add(fmt::format("thread {} computes", i + 1), path.computing[i]);
  }
  add("from shown to seen", path.delivery);
  return table;
}

}  // namespace

std::string titleOf(const Profile& profile, const std::string& vehicle) {
  if (profile.run.team.members.empty()) {
    return fmt::format("{}: {} on the program's own thread, nothing to show", vehicle, profile.run.method);
  }
  return fmt::format("{}: {} by {} on {} threads, {} cores allowed", vehicle, profile.run.method, profile.run.scheme,
                     profile.run.threads, profile.run.team.cores.size());
}

Table placementTable(const TeamReport& team) {
  Table table{"cores",
              {{"thread", ""},
               {"core before", ""},
               {"core after", ""},
               {"pinned", ""},
               {"migrations", ""},
               {"voluntary switches", ""},
               {"involuntary", ""},
               {"priority", ""},
               {"why not more", ""}},
              {}};
  for (std::size_t i = 0; i < team.members.size(); ++i) {
    const MemberReport& each = team.members[i];
    table.rows.push_back({static_cast<long>(i + 1), known(static_cast<long>(each.core_before)),
                          known(static_cast<long>(each.core_after)), each.pinned, known(each.usage.migrations),
                          known(each.usage.voluntary), known(each.usage.involuntary), each.priority,
                          orNothing(each.priority_note)});
  }
  return table;
}

Table histogramTable(const std::string& name, const std::string& what, const DurationSummary& durations) {
  Table table{name, {{"from", "us"}, {"to", "us"}, {what, ""}, {"share", "%"}}, {}, 2};
  if (durations.bins.empty()) return table;
  constexpr std::size_t kRows = 12;
  const double begin = durations.bins.front().begin;
  const double end = durations.bins.back().end;
  const double ratio = std::pow(end / std::max(begin, 1e-12), 1.0 / static_cast<double>(kRows));
  double limit = begin;
  for (const DurationSummary::Bin& bin : durations.bins) {
    // Bins are never cut: a row ends with the bin that reaches its limit.
    if (table.rows.empty() || bin.begin >= limit) {
      table.rows.push_back({1e6 * bin.begin, 1e6 * bin.end, 0L, 0.0});
      limit = std::max(bin.begin * ratio, bin.end);
    }
    std::vector<Cell>& row = table.rows.back();
    row[1] = 1e6 * bin.end;
    row[2] = std::get<long>(row[2]) + bin.count;
    row[3] = 100.0 * static_cast<double>(std::get<long>(row[2])) / static_cast<double>(durations.count);
  }
  return table;
}

std::vector<Cell> quantileRow(const std::string& name, const DurationSummary& durations) {
  const auto us = [](double seconds) { return Cell(1e6 * seconds); };
  return {name,
          durations.count,
          us(durations.mean),
          us(durations.p50),
          us(durations.p99),
          us(durations.p999),
          us(durations.most)};
}

Table quantileTable(const std::string& name, std::vector<std::vector<Cell>> rows) {
  return {name,
          {{"of", ""}, {"count", ""}, {"mean", "us"}, {"p50", "us"}, {"p99", "us"}, {"p99.9", "us"}, {"longest", "us"}},
          std::move(rows)};
}

Document documentOf(const RunNames& names, const Profile& profile) {
  const Trace& trace = profile.trace;
  Document document;
  document.facts = factsOf(names, profile.run.speed);
  for (Fact& fact : sharingFacts(profile.run)) document.facts.push_back(std::move(fact));
  if (profile.run.team.members.empty()) {
    document.tables = {decisionTable(profile.run.decision), speedTable(profile)};
    document.tables.back().rows.resize(1);
    document.remarks = {
        "the run stayed on the program's own thread, which waits for no other: there is nothing more to show"};
    return document;
  }
  const double untraced = profile.plain.median();
  document.facts.insert(
      document.facts.end(),
      {{"waiting", wordsOf(profile.run.team.waiting), ""},
       {"cores allowed", static_cast<long>(profile.run.team.cores.size()), ""},
       {"steps", profile.run.statistics.steps, ""},
       {"traced steps", trace.traced_steps, ""},
       {"clock reading", 1e9 * trace.stamp_cost, "ns"},
       {"tracing, counted", trace.run_seconds > 0.0 ? 100.0 * trace.overhead / trace.run_seconds : 0.0,
        "% of thread 1"},
       {"tracing, measured", untraced > 0.0 ? Cell(100.0 * (profile.traced.median() / untraced - 1.0)) : Cell(), "%"}});
  document.tables = {decisionTable(profile.run.decision),
                     speedTable(profile),
                     workTable(profile.run),
                     shareTable(profile),
                     placementTable(profile.run.team),
                     waitTable(trace),
                     pathTable(trace),
                     quantileTable("step times of thread 1, all steps", {quantileRow("step", trace.steps)}),
                     histogramTable("histogram of the step times", "steps", trace.steps)};
  if (!trace.clock_note.empty()) document.remarks.push_back(trace.clock_note);
  if (trace.dropped_steps > 0) {
    document.remarks.push_back(fmt::format(
        "{} steps were not traced because the buffer was full; take a larger --every", trace.dropped_steps));
  }
  std::string noted;
  for (const MemberReport& each : profile.run.team.members) {
    if (each.pinned || each.pinning_note == noted) continue;
    noted = each.pinning_note;
    document.remarks.push_back(fmt::format("not pinned: {}", noted));
  }
  for (const std::string& line : profile.run.team.members.front().usage.missing) {
    document.remarks.push_back(fmt::format("not available: {}", line));
  }
  return document;
}

}  // namespace vehicle::report
