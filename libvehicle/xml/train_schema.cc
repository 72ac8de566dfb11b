#include "libvehicle/definition/train.h"

#include "libvehicle/xml/schema_binding.h"
#include "libvehicle/xml/schema_files.h"

namespace vehicle::schema {

ElementRow trainRow() {
  constexpr Sign kPositive = Sign::kPositive;
  constexpr Sign kNotNegative = Sign::kNotNegative;
  return object<Train>(
      "train",
      "Vehicles behind each other, the leading one first, and the couplings between them. Vehicle number 2 is called "
      "NAME_2 and its parts NAME_2.PART, in results as in scenarios.",
      R"(<train name="three-coaches" format="1"> ... </train>)",
      {name<&Train::name>("what results and reports call it"), format()},
      {
          text<&Train::title>("title", "One line for reports.", "<title>Three coaches, coupled</title>"),
          text<&Train::source>("source", "Where the numbers come from.", "<source>Test run of 2019</source>"),
          element<&Train::vehicles>(
              "vehicle", "A vehicle file, and how many of them follow each other here.",
              R"(<vehicle file="../vehicles/coach.xml" count="3" spacing="26 m"/>)",
              {
                  bound<&TrainVehicle::file>("file", ValueKind::kFile, "path, counted from the folder of this file")
                      .asRequired(),
                  bound<&TrainVehicle::name>("name", ValueKind::kName,
                                             "what they are called in results; without it as the vehicle's file says"),
                  integer<&TrainVehicle::count>("count", 1, Train::kMostVehicles, "how many").orElse("1"),
                  quantity<&TrainVehicle::spacing>("spacing", Dimension::kLength, kPositive,
                                                   "length of track that each takes, its origin in the middle: from "
                                                   "origin to origin of equal vehicles")
                      .asRequired(),
                  quantity<&TrainVehicle::end_x>("end_x", Dimension::kLength, kPositive,
                                                 "distance of its coupled ends from the CG of its carbody; without it "
                                                 "as the coupling says"),
              }),
          element<&Train::couplings>(
              "coupling",
              "A vertical spring and damper from the rear end of a carbody to the front end of the next; it carries no "
              "static load. One serves all; or one between each two vehicles, front to rear; without any, the vehicles "
              "run uncoupled.",
              R"(<coupling stiffness_z="50 kN/m" damping_z="20 kN*s/m" end_x="12.5 m"/>)",
              {
                  quantity<&Coupling::stiffness_z>("stiffness_z", Dimension::kStiffness, kNotNegative,
                                                   "vertical stiffness")
                      .orElse("0 kN/m"),
                  quantity<&Coupling::damping_z>("damping_z", Dimension::kDamping, kNotNegative, "vertical damping")
                      .orElse("0 kN*s/m"),
                  quantity<&Coupling::end_x>("end_x", Dimension::kLength, kPositive,
                                             "distance of its ends from the CG of the carbodies; vehicles may give "
                                             "their own"),
                  quantity<&Coupling::z>("z", Dimension::kLength, Sign::kAny,
                                         "height above rail top where heights are given; without it that of each "
                                         "carbody's CG"),
              }),
      });
}

}  // namespace vehicle::schema
