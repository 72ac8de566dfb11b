#pragma once

#include <memory>
#include <vector>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/flat/flat_equation_set.h"
#include "libvehicle/flat/flat_model.h"
#include "libvehicle/model/compiled_model.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// The paper's equations for the vehicles of a train and the couplings between their carbodies, (8.1)-(8.3) of
/// docs/theory/vertical.md. States, channels and columns are in the train's own order, as in every form; inside,
/// vehicles and wheels count from the front. Immutable: one object serves any number of threads.
class FlatTrain : public System {
 public:
  [[nodiscard]] virtual const std::vector<FlatParameters>& vehicles() const = 0;  // the leading one first
  /// Coupling i joins the vehicles i and i + 1; zero stiffness and damping where there is none.
  [[nodiscard]] virtual const std::vector<FlatCoupling>& couplings() const = 0;
};

/// Why the form "flat" cannot represent this vehicle or train, one problem an element; empty if it can. A train of it
/// is several vehicles that flatUnsupported() would accept, each coupled to its neighbours at most, by one suspension from
/// carbody to carbody.
[[nodiscard]] ProblemList flatSystemUnsupported(const Topology& topology);

/// The form "flat": a FlatForm of one vehicle, a FlatTrain of several.
/// @throws InvalidInput with flatSystemUnsupported()
[[nodiscard]] std::unique_ptr<System> buildFlatSystem(const CompiledModel& model);

/// @throws InvalidInput as buildFlatSystem()
[[nodiscard]] std::unique_ptr<FlatTrain> buildFlatTrain(const CompiledModel& train);

}  // namespace vehicle
