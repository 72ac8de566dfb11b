#include "benchmarks/built_by.h"

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "vehicle_commit.h"

namespace vehicle::bench {

std::string builtBy() { return "g++ " __VERSION__ "," VEHICLE_FLAGS "," VEHICLE_COMMIT; }

void requireKnownCommit(const std::string& results) {
  constexpr std::string_view kCommit = VEHICLE_COMMIT;
  if (results.empty() || (!kCommit.empty() && !kCommit.ends_with("-dirty"))) return;
  std::fprintf(stderr, "%s: results of %s are not kept: nobody could measure them again; commit first, then build\n",
               results.c_str(), kCommit.empty() ? "no commit" : VEHICLE_COMMIT);
  std::exit(2);
}

}  // namespace vehicle::bench
