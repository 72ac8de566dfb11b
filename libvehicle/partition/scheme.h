#pragma once

#include <optional>
#include <string>
#include <vector>

namespace vehicle {

/// How the work of a method is shared among threads. A scheme never changes a number: each gives the bits of the
/// serial run of the same method, for every number of threads.
enum class Scheme {
  kSerial,    // "serial"    one thread; a long train goes through the cache in blocks
  kStages,    // "stages"    rk4: every thread its equations, the state exchanged at every stage (the paper's design)
  kHalo,      // "halo"      rk4: neighbours' equations computed redundantly, one exchange a step
  kPipeline,  // "pipeline"  rk4: one thread steps, the others compute the input ahead in blocks
  kSplit,     // "split"     symmetric vehicle: bounce and pitch go their own ways, no exchange
};
[[nodiscard]] const std::vector<std::string>& schemeNames();
[[nodiscard]] const char* nameOf(Scheme scheme);
/// @throws std::invalid_argument for a name that does not exist
[[nodiscard]] Scheme schemeOf(const std::string& name);

/// Whether its threads have equations of their own, so that a map matters.
[[nodiscard]] bool sharesEquations(Scheme scheme);

/// Who computes which equation.
enum class EquationMap {
  kPaper,  // "paper"  the source paper's four threads: (5) | (2) and the rail (6) | (3) | (4)
  kBody,   // "body"   all equations of a body on one thread
  kAuto,   // "auto"   graph partition by measured cost: equal work, few neighbours
};
[[nodiscard]] const std::vector<std::string>& equationMapNames();
[[nodiscard]] const char* nameOf(EquationMap map);
/// @throws std::invalid_argument for a name that does not exist
[[nodiscard]] EquationMap equationMapOf(const std::string& name);

/// How threads are to share one run.
struct Sharing {
  int threads = 1;                       // 0 where a choice is made: as many as are fastest
  std::optional<Scheme> scheme{};        // nothing: serial on 1 thread, else chosen
  EquationMap map = EquationMap::kAuto;  // stages, halo
  friend bool operator==(const Sharing&, const Sharing&) = default;
};

}  // namespace vehicle
