#include <cstdio>

#include "libvehicle/simulate/simulate.h"
#include "libvehicle/storage/csv.h"
#include "libvehicle/xml/reader.h"

int main(int, char** argv) {
  const auto coach = vehicle::readVehicle(argv[1]).orThrow();
  const auto result = vehicle::simulate(coach, vehicle::readScenario(argv[2]).orThrow());
  vehicle::writeCsv(result.history, argv[3]);
  std::printf("%s, %s: %zu samples\n", result.form.c_str(), result.method.c_str(), result.history.samples());
}
