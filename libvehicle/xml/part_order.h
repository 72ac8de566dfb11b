#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "libvehicle/xml/schema.h"

namespace vehicle {

/// One child element to be written: its row of the schema and its struct.
struct PartToWrite {
  const ElementRow* row = nullptr;
  const void* object = nullptr;
  std::vector<PartToWrite> members;  // of a group
};

/// The children of an element in an order that, read back, fills each list of the parent in its order, with the
/// parts of a group inside it.
/// @throws std::invalid_argument if there is no such order
[[nodiscard]] std::vector<PartToWrite> orderOfWriting(const ElementRow& row, const void* object);

}  // namespace vehicle
