#include <cstdio>
#include <fstream>

#include "libvehicle/report/run/run_document.h"
#include "libvehicle/simulate/simulate.h"
#include "libvehicle/storage/csv.h"
#include "libvehicle/xml/reader.h"

int main(int, char** argv) {
  const auto coach = vehicle::readVehicle(argv[1]).orThrow();
  const auto track = vehicle::readScenario(argv[2]).orThrow();
  const auto result = vehicle::simulate(coach, track);
  vehicle::writeCsv(result.history, argv[3]);
  const auto document = vehicle::report::documentOf({coach.name, track.name, result.form, result.method}, result,
                                                    vehicle::report::Format::kJson);
  std::ofstream page(argv[4]);
  vehicle::report::print(document, vehicle::report::Format::kJson, page);
  std::printf("%s, %s: %zu samples\n", result.form.c_str(), result.method.c_str(), result.history.samples());
}
