#include "tests/support/source_tree.h"

namespace vehicle::test {

std::string sourcePath(const std::string& relative) {
  const std::string top = VEHICLE_SOURCE_DIR;
  return relative.empty() ? top : top + "/" + relative;
}

}  // namespace vehicle::test
