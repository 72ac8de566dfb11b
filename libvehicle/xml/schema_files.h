#pragma once

#include "libvehicle/xml/schema.h"

// The parts of the schema table, one file each: vehicle_schema.cc and so on.
namespace vehicle::schema {

[[nodiscard]] ElementRow vehicleRow();
[[nodiscard]] ElementRow trainRow();
[[nodiscard]] ElementRow scenarioRow();
[[nodiscard]] ElementRow suiteRow();
[[nodiscard]] ElementRow studyRow();

}  // namespace vehicle::schema
