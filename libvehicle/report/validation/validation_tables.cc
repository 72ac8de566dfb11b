#include "libvehicle/report/validation/validation_tables.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "libvehicle/report/document/engineering_units.h"
#include "libvehicle/validation/overall.h"

namespace vehicle::report {
namespace {

Cell optional(const std::optional<double>& value) { return value ? Cell(*value) : Cell(); }

bool isJudged(const PairAgreement& pair) { return pair.verdict != Verdict::kNotJudged; }

/// The pair of the reference (run 0) and this run, if it was compared.
const PairAgreement* againstReference(const ValidationReport& report, std::size_t run) {
  for (const PairAgreement& pair : report.pairs) {
    if (pair.first == 0 && pair.second == run && isJudged(pair)) return &pair;
  }
  return nullptr;
}

Table runTable(const ValidationReport& report) {
  Table table{"runs",
              {{"run", ""},
               {"steps", ""},
               {"evaluations", ""},
               {"rejected", ""},
               {"run time", "s"},
               {"difference from exact", "of peak"},
               {"order", ""},
               {"no result because", ""}},
              {}};
  for (std::size_t i = 0; i < report.runs.size(); ++i) {
    const ValidationRun& run = report.runs[i];
    Cell difference;
    if (const PairAgreement* pair = againstReference(report, i)) {
      double largest = 0.0;
      for (const GroupAgreement& group : pair->groups) largest = std::max(largest, group.relative);
      difference = largest;
    }
    table.rows.push_back({run.key.text(), run.statistics.steps, run.statistics.evaluations, run.statistics.rejected,
                          run.wall_seconds, difference, optional(run.order),
                          run.reason.empty() ? Cell() : Cell(run.reason)});
  }
  const bool all_have_results =
      std::all_of(report.runs.begin(), report.runs.end(), [](const ValidationRun& run) { return run.reason.empty(); });
  if (all_have_results) {
    table.columns.pop_back();
    for (std::vector<Cell>& row : table.rows) row.pop_back();
  }
  return table;
}

// The quantities of those runs that `shown` accepts.
template <class Shown>
Table groupTable(const ValidationReport& report, Shown shown) {
  Table table{"quantities against the exact solution of the matrix form",
              {{"run", ""},
               {"quantities", ""},
               {"max error", "of peak"},
               {"NRMSE", ""},
               {"magnitude M", ""},
               {"phase P", ""},
               {"combined C", ""},
               {"largest in", ""}},
              {},
              2};
  for (const PairAgreement& pair : report.pairs) {
    if (pair.first != 0 || report.runs[pair.second].key.refine != 1 || !shown(pair)) continue;
    for (const GroupAgreement& group : pair.groups) {
      table.rows.push_back({report.runs[pair.second].key.text(), std::string(nameOf(group.group)), group.relative,
                            group.nrmse, group.magnitude, group.phase, group.combined, group.column});
    }
  }
  return table;
}

void addPair(Table& table, const ValidationReport& report, const PairAgreement& pair) {
  if (!isJudged(pair)) {
    table.rows.push_back({report.runs[pair.first].key.text(),
                          report.runs[pair.second].key.text(),
                          {},
                          {},
                          std::string(nameOf(pair.verdict)),
                          {},
                          pair.why});
    return;
  }
  const ColumnAgreement& worst = pair.columns[pair.worst];
  table.rows.push_back({report.runs[pair.first].key.text(), report.runs[pair.second].key.text(), pair.relative,
                        optional(pair.expected), std::string(nameOf(pair.verdict)), worst.column.name, pair.why});
}

const std::vector<TableColumn> kPairColumns = {{"run", ""},
                                               {"against", ""},
                                               {"difference", "of peak"},
                                               {"expected", "of peak"},
                                               {"verdict", ""},
                                               {"nearest to its limit", ""},
                                               {"expected because of", ""}};

// Two forms, or two methods on one form: how many of their pairs are inside, and the pair of which least
// disagreement was expected, because that one says most.
Table formTable(const ValidationReport& report) {
  struct Entry {
    std::string first, second;
    long pairs = 0, inside = 0;
    const PairAgreement* strictest = nullptr;
  };
  std::vector<Entry> entries;
  for (const PairAgreement& pair : report.pairs) {
    std::string first = report.runs[pair.first].key.form;
    std::string second = report.runs[pair.second].key.form;
    const auto entry = std::find_if(entries.begin(), entries.end(), [&](const Entry& each) {
      return (each.first == first && each.second == second) || (each.first == second && each.second == first);
    });
    Entry& found = entry == entries.end() ? entries.emplace_back(Entry{first, second}) : *entry;
    ++found.pairs;
    found.inside += pair.verdict == Verdict::kInside ? 1 : 0;
    const auto size = [](const PairAgreement* each) { return each->expected.value_or(HUGE_VAL); };
    if (!isJudged(pair)) continue;
    if (found.strictest == nullptr || size(&pair) < size(found.strictest)) found.strictest = &pair;
  }
  Table table{"form against form",
              {{"form", ""},
               {"against", ""},
               {"pairs", ""},
               {"inside", ""},
               {"strictest pair", ""},
               {"difference", "of peak"},
               {"expected", "of peak"},
               {"because of", ""}},
              {},
              2};
  for (const Entry& each : entries) {
    if (each.strictest == nullptr) {
      table.rows.push_back({each.first, each.second, each.pairs, each.inside, {}, {}, {}, {}});
      continue;
    }
    const PairAgreement& pair = *each.strictest;
    const RunKey& a = report.runs[pair.first].key;
    const RunKey& b = report.runs[pair.second].key;
    const std::string methods =
        fmt::format("{} / {}", a.text().substr(a.form.size() + 1), b.text().substr(b.form.size() + 1));
    table.rows.push_back(
        {each.first, each.second, each.pairs, each.inside, methods, pair.relative, optional(pair.expected), pair.why});
  }
  return table;
}

// Of each form the run that is farthest from the exact solution; one shared among threads repeats its serial run.
bool isWorstOfItsForm(const ValidationReport& report, const PairAgreement& pair) {
  if (!report.runs[pair.second].key.scheme.empty()) return false;
  return std::none_of(report.pairs.begin(), report.pairs.end(), [&](const PairAgreement& other) {
    return other.first == 0 && report.runs[other.second].key.form == report.runs[pair.second].key.form &&
           report.runs[other.second].key.refine == 1 && other.relative > pair.relative;
  });
}

Table notRunTable(const ValidationReport& report) {
  Table table{"not run", {{"form", ""}, {"method", ""}, {"why", ""}}, {}};
  for (const Unsupported& each : report.unsupported) {
    table.rows.push_back({each.form, each.method.empty() ? Cell() : Cell(each.method), each.reason});
  }
  return table;
}

/// Pairs by their verdict, of one or several cases.
struct PairCounts {
  std::size_t inside = 0, outside = 0, by_design = 0, not_judged = 0;

  void add(const ValidationReport& report) {
    inside += report.count(Verdict::kInside);
    outside += report.count(Verdict::kOutside);
    by_design += report.count(Verdict::kByDesign);
    not_judged += report.count(Verdict::kNotJudged);
  }
  [[nodiscard]] std::string text() const {
    return fmt::format("{} pairs inside their expected size, {} outside{}{}", inside, outside,
                       by_design > 0 ? fmt::format(", {} differ by design", by_design) : "",
                       not_judged > 0 ? fmt::format(", {} not judged", not_judged) : "");
  }
};

std::string verdictOf(const ValidationReport& report) {
  if (report.stopped) return "interrupted";
  if (report.failed()) return "failed";
  if (report.count(Verdict::kOutside) > 0) return "OUTSIDE";
  return report.inside() ? "inside" : "not judged";
}

}  // namespace

Document documentOf(const ValidationReport& report, Detail detail) {
  Document document;
  document.facts = {{"vehicle", report.vehicle, ""},
                    {"scenario", report.scenario, ""},
                    {"speed", report.speed, "m/s"},
                    {"inside", report.inside(), ""},
                    {"pairs not judged", static_cast<long>(report.count(Verdict::kNotJudged)), ""}};
  Table pairs{"pairs", kPairColumns, {}, 2};
  for (const PairAgreement& pair : report.pairs) {
    if (detail == Detail::kAll || pair.verdict == Verdict::kOutside) addPair(pairs, report, pair);
  }
  const auto shown = [&](const PairAgreement& pair) {
    return detail == Detail::kAll || isWorstOfItsForm(report, pair);
  };
  document.tables = {runTable(report), groupTable(report, shown), formTable(report), std::move(pairs),
                     notRunTable(report)};
  document.remarks = report.notes;
  PairCounts counts;
  counts.add(report);
  document.remarks.push_back(counts.text());
  return document;
}

Document documentOf(const std::vector<ValidationReport>& reports) {
  Document document;
  Table cases{"cases",
              {{"vehicle", ""},
               {"scenario", ""},
               {"speed", "m/s"},
               {"runs", ""},
               {"inside", ""},
               {"outside", ""},
               {"by design", ""},
               {"not judged", ""},
               {"rounding", "of limit"},
               {"integration", "of limit"},
               {"geometry", "of limit"},
               {"verdict", ""}},
              {},
              3};
  Table outside{"pairs outside", kPairColumns, {}, 2};
  bool all_inside = true;
  PairCounts counts;
  for (const ValidationReport& report : reports) {
    all_inside = all_inside && report.inside();
    counts.add(report);
    Cell used[3];  // the pair nearest to its limit, by the main source of that limit
    for (const PairAgreement& pair : report.pairs) {
      if (pair.verdict == Verdict::kOutside) addPair(outside, report, pair);
      if (!pair.source || !pair.expected || !(*pair.expected > 0.0)) continue;
      Cell& cell = used[static_cast<int>(*pair.source)];
      const double share = pair.relative / *pair.expected;
      if (!std::holds_alternative<double>(cell) || std::get<double>(cell) < share) cell = share;
    }
    cases.rows.push_back(
        {report.vehicle, report.scenario, report.speed, static_cast<long>(report.runs.size()),
         static_cast<long>(report.count(Verdict::kInside)), static_cast<long>(report.count(Verdict::kOutside)),
         static_cast<long>(report.count(Verdict::kByDesign)), static_cast<long>(report.count(Verdict::kNotJudged)),
         used[0], used[1], used[2], verdictOf(report)});
  }
  document.facts = {{"cases", static_cast<long>(reports.size()), ""},
                    {"inside", all_inside, ""},
                    {"pairs not judged", static_cast<long>(counts.not_judged), ""}};
  document.tables = {std::move(cases), std::move(outside)};
  document.remarks.push_back(counts.text());
  return document;
}

std::vector<std::string> complaintsOf(const ValidationReport& report) {
  std::vector<std::string> complaints;
  const std::string where = caseName(report);
  for (const ValidationRun& run : report.runs) {
    if (run.ending == RunEnding::kFailed) complaints.push_back(fmt::format("{}: {}", where, run.reason));
    if (run.ending == RunEnding::kOutOfTime) {
      complaints.push_back(fmt::format("{}: {} is not judged: {}", where, run.key.text(), run.reason));
    }
  }
  for (const PairAgreement& pair : report.pairs) {
    if (pair.verdict != Verdict::kOutside) continue;
    const ColumnAgreement& worst = pair.columns[pair.worst];
    const double expected = worst.expected.value_or(0.0);
    const ShownUnit unit = shownUnit(worst.column.unit, std::max(worst.norms.max_difference, expected));
    complaints.push_back(fmt::format("{}: {} against {}: {} differs by {:.3g} {}, expected at most {:.3g} {} ({})",
                                     where, report.runs[pair.first].key.text(), report.runs[pair.second].key.text(),
                                     worst.column.name, unit.factor * worst.norms.max_difference, unit.name,
                                     unit.factor * expected, unit.name, pair.why));
  }
  return complaints;
}

std::string whyNothing(const ValidationReport& report) {
  const bool all_finished = std::all_of(report.runs.begin(), report.runs.end(),
                                        [](const ValidationRun& run) { return run.ending == RunEnding::kFinished; });
  if (!all_finished || report.count(Verdict::kInside) + report.count(Verdict::kOutside) > 0) return {};
  std::string why;
  for (const Unsupported& each : report.unsupported) {
    why += "; " + (each.method.empty() ? each.form + ": " : "") + each.reason;
  }
  return fmt::format("{}: nothing is judged: no two runs can be compared{}", caseName(report), why);
}

}  // namespace vehicle::report
