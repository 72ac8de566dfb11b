#include "benchmarks/built_by.h"

namespace vehicle::bench {

std::string builtBy() { return "g++ " __VERSION__ "," VEHICLE_FLAGS "," VEHICLE_COMMIT; }

}  // namespace vehicle::bench
