#include "libvehicle/partition/scheme.h"

#include <algorithm>
#include <stdexcept>

namespace vehicle {

namespace {

std::size_t numberOf(const char* what, const std::string& name, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  std::string message = std::string("unknown ") + what + " \"" + name + "\"; must be ";
  for (std::size_t i = 0; i < names.size(); ++i) message += (i == 0 ? "" : " | ") + names[i];
  throw std::invalid_argument(message);
}

}  // namespace

const std::vector<std::string>& schemeNames() {
  static const std::vector<std::string> names = {"serial", "stages", "halo", "pipeline", "split"};
  return names;
}

const char* nameOf(Scheme scheme) { return schemeNames()[static_cast<std::size_t>(scheme)].c_str(); }

Scheme schemeOf(const std::string& name) { return static_cast<Scheme>(numberOf("scheme", name, schemeNames())); }

bool sharesEquations(Scheme scheme) { return scheme == Scheme::kStages || scheme == Scheme::kHalo; }

const std::vector<std::string>& equationMapNames() {
  static const std::vector<std::string> names = {"paper", "body", "auto"};
  return names;
}

const char* nameOf(EquationMap map) { return equationMapNames()[static_cast<std::size_t>(map)].c_str(); }

EquationMap equationMapOf(const std::string& name) {
  return static_cast<EquationMap>(numberOf("map", name, equationMapNames()));
}

}  // namespace vehicle
