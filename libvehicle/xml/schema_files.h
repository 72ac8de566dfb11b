#pragma once

#include "libvehicle/xml/schema.h"

// The three parts of the schema table, one file each: vehicle_schema.cc, scenario_schema.cc, suite_schema.cc.
namespace vehicle::schema {

[[nodiscard]] ElementRow vehicleRow();
[[nodiscard]] ElementRow scenarioRow();
[[nodiscard]] ElementRow suiteRow();

}  // namespace vehicle::schema
