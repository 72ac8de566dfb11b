#pragma once

#include <span>
#include <string>

namespace vehicle {

/// Ends a run that cannot go on: "rk4: the state is not finite at t = 0.35 s; ...".
/// @param t  [s] the time reached
/// @throws std::runtime_error, always
[[noreturn]] void failRun(const char* method, double t, const std::string& what);

/// failRun() naming the first state that is infinite or NaN.
[[noreturn]] void failNotFinite(const char* method, double t, std::span<const double> x);

/// @throws std::runtime_error through failNotFinite() if a state is infinite or NaN
inline void requireFinite(const char* method, double t, std::span<const double> x) {
  double zero = 0.0;
  for (const double value : x) zero += 0.0 * value;
  if (zero != 0.0) failNotFinite(method, t, x);
}

/// @throws std::invalid_argument unless x0 has `size` finite values
void checkStart(const char* method, std::span<const double> x0, int size);

/// @throws std::invalid_argument unless the system and the input have the same number of channels
void checkChannels(const char* method, int of_system, int of_input);

}  // namespace vehicle
