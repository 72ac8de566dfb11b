#pragma once

#include <memory>

#include "libvehicle/flat/flat_form.h"
#include "libvehicle/flat/flat_layout.h"

namespace vehicle {

/// One of the printed readings of the paper's equations, kept for teaching. Private to this room.
/// @param layout   of a vehicle that flatUnsupported() finds nothing against   @param variant  not kConsistent
[[nodiscard]] std::unique_ptr<FlatForm> buildPrintedForm(const CompiledModel& model, const FlatLayout& layout,
                                                         FlatVariant variant);

}  // namespace vehicle
