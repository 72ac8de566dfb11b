#include "libvehicle/integrate/failure.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace vehicle {

void failRun(const char* method, double t, const std::string& what) {
  std::ostringstream message;
  message.precision(12);
  message << method << ": " << what << " at t = " << t << " s";
  throw std::runtime_error(message.str());
}

void failNotFinite(const char* method, double t, std::span<const double> x) {
  const auto bad = std::find_if_not(x.begin(), x.end(), [](double value) { return std::isfinite(value); });
  failRun(method, t,
          "state " + std::to_string(bad - x.begin()) +
              " is no longer finite (the step is too long for the fastest motion, or the system is unstable)");
}

void checkStart(const char* method, std::span<const double> x0, int size) {
  if (static_cast<int>(x0.size()) != size) {
    throw std::invalid_argument(std::string(method) + ": x0 has " + std::to_string(x0.size()) +
                                " values, must have " + std::to_string(size) + ", one a state");
  }
  for (std::size_t i = 0; i < x0.size(); ++i) {
    if (!std::isfinite(x0[i])) {
      throw std::invalid_argument(std::string(method) + ": x0[" + std::to_string(i) + "] = " + std::to_string(x0[i]) +
                                  ", must be finite");
    }
  }
}

void checkChannels(const char* method, int of_system, int of_input) {
  if (of_system == of_input) return;
  throw std::invalid_argument(std::string(method) + ": the input has " + std::to_string(of_input) +
                              " channels, must have " + std::to_string(of_system) + ", one a wheelset of the system");
}

}  // namespace vehicle
