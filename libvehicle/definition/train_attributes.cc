#include "libvehicle/definition/train_attributes.h"

#include "libvehicle/definition/attribute_binding.h"

namespace vehicle {

namespace {

using namespace attributes;
using enum Dimension;
using enum Sign;

constexpr AttributeRow kTrain[] = {name<&Train::name>("what results and reports call it")};

constexpr AttributeRow kTrainVehicle[] = {
    file<&TrainVehicle::file>("path, counted from the folder of this file").asRequired(),
    bound<&TrainVehicle::name>("name", ValueKind::kName,
                               "what they are called in results; without it as the vehicle's file says"),
    integer<&TrainVehicle::count>("count", 1, Train::kMostVehicles, "how many").orElse("1"),
    quantity<&TrainVehicle::spacing>("spacing", kLength, kPositive,
                                     "length of track that each takes, its origin in the middle: from "
                                     "origin to origin of equal vehicles")
        .asRequired(),
    quantity<&TrainVehicle::end_x>("end_x", kLength, kPositive,
                                   "distance of its coupled ends from the CG of its carbody; without it "
                                   "as the coupling says"),
};

// Studies address couplings as the elements that assembled() makes of them.
constexpr AttributeRow kCoupling[] = {
    quantity<&Coupling::stiffness_z>("stiffness_z", kStiffness, kNotNegative, "vertical stiffness").orElse("0 kN/m"),
    quantity<&Coupling::damping_z>("damping_z", kDamping, kNotNegative, "vertical damping").orElse("0 kN*s/m"),
    quantity<&Coupling::end_x>("end_x", kLength, kPositive,
                               "distance of its ends from the CG of the carbodies; vehicles may give their own"),
    quantity<&Coupling::z>("z", kLength, kAny,
                           "height above rail top where heights are given; without it that of each carbody's CG"),
};

}  // namespace

template <>
std::span<const AttributeRow> attributesOf<Train>() {
  return kTrain;
}
template <>
std::span<const AttributeRow> attributesOf<TrainVehicle>() {
  return kTrainVehicle;
}
template <>
std::span<const AttributeRow> attributesOf<Coupling>() {
  return kCoupling;
}

}  // namespace vehicle
