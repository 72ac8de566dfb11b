#pragma once

#include "libvehicle/threads/team.h"

namespace vehicle {

/// Puts the calling thread on its core and gives it its priority, as far as the system permits, and writes down
/// what was got and why not more.
/// @param number  of the member
/// @param team    its cores are read, the report of that member is written
void placeThisThread(const TeamPolicy& policy, int number, TeamReport& team);

/// Gives the calling thread that priority as far as permitted.
/// @param spare  a core is left over for everybody else
struct GrantedPriority {
  std::string got{};   // "normal" | "nice -10" | "SCHED_FIFO 10"
  std::string note{};  // why less than asked, or empty
};
[[nodiscard]] GrantedPriority raiseThisThread(Priority priority, bool spare);

}  // namespace vehicle
