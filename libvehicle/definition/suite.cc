#include "libvehicle/definition/suite.h"

#include <map>
#include <string_view>

#include "libvehicle/definition/judge.h"

namespace vehicle {

namespace {

// A suite crosses its speeds with everything else: beyond this a typing error is likelier than a wish.
constexpr int kMostSpeeds = 10'000;

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
  const bool from = judge.positive("from", range.from, Dimension::kSpeed);
  const bool to = judge.positive("to", range.to, Dimension::kSpeed);
  const bool count = judge.knows({"count"});
  if (count && (range.count < 1 || range.count > kMostSpeeds)) {
    judge.say(judge.written("count", range.count), "must be 1..10000");
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
