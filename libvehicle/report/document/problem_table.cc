#include "libvehicle/report/document/problem_table.h"

namespace vehicle::report {

Table problemTable() {
  return {"files", {{"file", ""}, {"line", ""}, {"verdict", ""}, {"element", ""}, {"message", ""}, {"remedy", ""}}, {}};
}

void addProblems(const std::string& file, const ProblemList& problems, Table& table) {
  if (problems.empty()) table.rows.push_back({file, {}, std::string("ok"), {}, {}, {}});
  for (const Problem& problem : problems) {
    table.rows.push_back({problem.place.file, static_cast<long>(problem.place.line), std::string("error"),
                          problem.element, problem.message, problem.remedy});
  }
}

}  // namespace vehicle::report
