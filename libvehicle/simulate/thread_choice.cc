#include "libvehicle/simulate/thread_choice.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/simulate/forms.h"
#include "libvehicle/simulate/methods.h"

namespace vehicle {

namespace {

constexpr const char* kRemedy = "take --threads 1";

std::string whyNotShared(const std::string& form, const std::string& method) {
  if (isSimbodyForm(form)) {
    return fmt::format("the form {} runs on one thread: Simbody computes all of its equations together; {}", form,
                       kRemedy);
  }
  const Method& entry = methodNamed(method);
  if (entry.schemes.size() > 1) return {};
  return fmt::format("the method {} runs on one thread{}{}; {}, or method rk4", method,
                     entry.alone_because.empty() ? "" : ": ", entry.alone_because, kRemedy);
}

}  // namespace

std::vector<Scheme> schemesOf(const std::string& method) {
  const std::vector<Scheme>& schemes = methodNamed(method).schemes;
  return schemes.empty() ? std::vector{Scheme::kSerial} : schemes;
}

std::string threadsUnsupported(const std::string& form, const std::string& method, const Sharing& sharing) {
  const int threads = sharing.threads;
  if (threads < 0 || threads > kMostThreads) {
    throw std::invalid_argument(
        fmt::format("threads = {}, must be 1..{}, or 0 to let a calibration choose", threads, kMostThreads));
  }
  const bool serial = sharing.scheme ? *sharing.scheme == Scheme::kSerial : threads <= 1;
  if (serial) {
    return threads <= 1 ? std::string{}
                        : fmt::format("scheme serial runs on one thread, not on {}; {}, or another scheme", threads,
                                      kRemedy);
  }
  if (std::string why = whyNotShared(form, method); !why.empty()) return why;
  if (sharing.scheme) {
    const std::vector<Scheme> possible = schemesOf(method);
    if (std::find(possible.begin(), possible.end(), *sharing.scheme) == possible.end()) {
      std::string known;
      for (const Scheme each : possible) known += fmt::format("{}{}", known.empty() ? "" : " | ", nameOf(each));
      return fmt::format("scheme {} does not share the work of {}; take {}", nameOf(*sharing.scheme), method, known);
    }
  }
  if (const int most = methodNamed(method).most_threads; most > 0 && threads > most) {
    return fmt::format("{} has two parts, bounce and pitch: it runs on 1 or 2 threads, not on {}", method, threads);
  }
  return {};
}

bool canBeShared(const std::string& form, const std::string& method) {
  return schemesOf(method).size() > 1 && whyNotShared(form, method).empty();
}

std::string mapUnsupported(const std::string& form, const std::string& method, const Sharing& sharing) {
  const char* map = nameOf(sharing.map);
  if (sharing.map == EquationMap::kAuto) return {};
  if (sharing.scheme) {
    if (sharesEquations(*sharing.scheme)) return {};
    return fmt::format(
        "--map {} has no effect with the scheme {}, whose threads have no equations of their own; omit --map, or take "
        "scheme stages or halo",
        map, nameOf(*sharing.scheme));
  }
  if (sharing.threads == 1) return {};  // one thread computes all equations, whatever the map
  if (std::string why = whyNotShared(form, method); !why.empty()) return why;
  const std::vector<Scheme> schemes = schemesOf(method);
  if (std::any_of(schemes.begin(), schemes.end(), sharesEquations)) return {};
  return fmt::format(
      "--map {} has no effect with the method {}, whose threads have no equations of their own; omit --map, or take "
      "method rk4",
      map, method);
}

}  // namespace vehicle
