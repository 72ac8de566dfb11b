#include "libvehicle/diagnostics/warning_collector.h"

namespace vehicle {

void WarningCollector::add(const Warnings& found, const std::string& run) {
  for (Warning each : found) {
    if (each.time && !run.empty()) each.subject = run + ": " + each.subject;
    if (texts_.insert(each.text()).second) all_.push_back(std::move(each));
  }
}

}  // namespace vehicle
