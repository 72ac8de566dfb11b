#include "libvehicle/study/evaluate/evaluation.h"

#include <limits>

namespace vehicle {

void Batch::reset(DesignSpan designs, std::size_t columns) {
  range = designs;
  values.assign(static_cast<std::size_t>(designs.size()) * columns, std::numeric_limits<double>::quiet_NaN());
  failures.clear();
  gaps.clear();
  warnings.clear();
}

}  // namespace vehicle
