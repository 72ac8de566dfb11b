#include "libvehicle/definition/suite.h"

#include <map>
#include <string_view>

#include "libvehicle/definition/judge.h"
#include "libvehicle/definition/suite_attributes.h"

namespace vehicle {

namespace {

void checkFiles(const std::vector<FileReference>& files, std::string_view kind, ProblemList& problems) {
  std::map<std::string_view, const FileReference*> seen;
  for (const FileReference& each : files) {
    Judge judge(problems, "<suite><" + std::string(kind) + '>', "", each.origin);
    if (!judge.knows({"file"})) continue;
    if (each.file.empty()) {
      judge.say("file is empty", "name a file, e.g. file=\"../" + std::string(kind) + "s/coach.xml\"");
    }
    const auto [first, fresh] = seen.try_emplace(each.file, &each);
    if (!fresh && !each.file.empty()) {
      judge.say(written("file", each.file) + " is listed twice" + inLine(first->second->origin), "list it once");
    }
  }
}

void checkChoices(const std::vector<NamedChoice>& choices, std::string_view kind, ProblemList& problems) {
  std::map<std::string_view, const NamedChoice*> seen;
  for (const NamedChoice& each : choices) {
    Judge judge(problems, "<suite><" + std::string(kind) + '>', "", each.origin);
    if (!judge.knows({"name"})) continue;
    if (each.name.empty()) judge.say("has no name", "name=\"...\" is required");
    const auto [first, fresh] = seen.try_emplace(each.name, &each);
    if (!fresh && !each.name.empty()) {
      judge.say(written("name", each.name) + " is listed twice" + inLine(first->second->origin), "list it once");
    }
  }
}

void checkSpeed(const SpeedRange& range, ProblemList& problems) {
  Judge judge(problems, "<suite><speed>", "", range.origin);
  const bool from = judge.number<&SpeedRange::from>(range);
  const bool to = judge.number<&SpeedRange::to>(range);
  judge.numbers<&SpeedRange::from, &SpeedRange::to>(range);
  const bool count = judge.knows({"count"});
  if (const AttributeRow& row = rowOf<&SpeedRange::count>();
      count && (range.count < row.least || range.count > row.most)) {
    judge.say(judge.written("count", range.count),
              "must be " + std::to_string(row.least) + ".." + std::to_string(row.most));
  }
  if (!from || !to) return;
  if (range.from > range.to) {
    judge.say(judge.written("from", range.from, Dimension::kSpeed) + " is above " +
                  judge.written("to", range.to, Dimension::kSpeed),
              "speeds go from the lower to the higher");
  } else if (count && range.from == range.to && range.count > 1) {
    judge.say("from and to are the same and count is " + std::to_string(range.count), "one speed has count=\"1\"");
  }
}

}  // namespace

std::vector<double> speedsOf(const Suite& suite) {
  std::vector<double> speeds;
  for (const SpeedRange& range : suite.speeds) {
    speeds.push_back(range.from);
    const int last = range.count - 1;
    for (int i = 1; i < last; ++i) speeds.push_back(range.from + (range.to - range.from) * i / last);
    if (last > 0) speeds.push_back(range.to);
  }
  return speeds;
}

ProblemList check(const Suite& suite) {
  ProblemList problems;
  Judge judge(problems, "<suite>", suite.name, suite.origin);
  judge.properName(suite.name);
  if (!suite.origin.hasStrange()) {
    if (suite.vehicles.empty()) judge.say("has no <vehicle>", "a suite has at least one");
    if (suite.scenarios.empty()) judge.say("has no <scenario>", "a suite has at least one");
  }
  checkFiles(suite.vehicles, "vehicle", problems);
  checkFiles(suite.scenarios, "scenario", problems);
  for (const SpeedRange& range : suite.speeds) checkSpeed(range, problems);
  checkChoices(suite.forms, "form", problems);
  checkChoices(suite.methods, "method", problems);
  problems.sortByPlace();
  return problems;
}

}  // namespace vehicle
