#pragma once

#include "libvehicle/xml/schema.h"

// The parts of the schema table, one file each: vehicle_schema.cc, scenario_schema.cc, suite_schema.cc, study_schema.cc.
namespace vehicle::schema {

[[nodiscard]] ElementRow vehicleRow();
[[nodiscard]] ElementRow scenarioRow();
[[nodiscard]] ElementRow suiteRow();
[[nodiscard]] ElementRow studyRow();

}  // namespace vehicle::schema
