#pragma once

#include <functional>
#include <vector>

#include "libvehicle/system/schedule.h"
#include "libvehicle/threads/team.h"

namespace vehicle {

/// One of several systems that know nothing of each other: a whole run of it on one thread, by any method of
/// `integrate`, on the schedule that all of them share.
struct IndependentPart {
  int states = 0;
  /// @param me  the member it runs on, for the trace of its steps; nullptr on the caller's own thread
  std::function<Statistics(const Observer&, Member* me)> run;
};

struct PartsRun {
  Statistics statistics;  // steps: of the first part; evaluations and rejected: of all
  TeamReport team;        // no members where the caller's thread did it all
};

/// Runs every part on a member of its own, with no exchange at all, and shows their samples together and in order:
/// the observer gets the states of part 0, then of part 1, ... of one sample. It is called by member 0, one call at a
/// time, a little after the sample was computed.
///
/// With fewer threads than parts a member runs its parts one after the other; those that come before its last are
/// kept whole, 8 bytes a state and sample, and the observer hears nothing meanwhile.
/// Numbers do not depend on the number of threads: every part is the same serial run.
/// @param samples  schedule.samples(), the one at the start included
/// @throws std::invalid_argument  for no parts, or a number of threads outside 1..parts
/// @throws                        what a part throws
PartsRun runIndependentParts(const std::vector<IndependentPart>& parts, int samples, const Observer& observe,
                             int threads, const TeamPolicy& team);

}  // namespace vehicle
