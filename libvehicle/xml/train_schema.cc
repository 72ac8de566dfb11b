#include "libvehicle/definition/train_attributes.h"

#include "libvehicle/xml/schema_binding.h"
#include "libvehicle/xml/schema_files.h"

namespace vehicle::schema {

ElementRow trainRow() {
  return root<Train>(
      "train",
      "Vehicles behind each other, the leading one first, and the couplings between them. Vehicle number 2 is called "
      "NAME_2 and its parts NAME_2.PART, in results as in scenarios.",
      R"(<train name="three-coaches" format="1"> ... </train>)",
      {
          text<&Train::title>("title", "One line for reports.", "<title>Three coaches, coupled</title>"),
          text<&Train::source>("source", "Where the numbers come from.", "<source>Test run of 2019</source>"),
          element<&Train::vehicles>("vehicle", "A vehicle file, and how many of them follow each other here.",
                                    R"(<vehicle file="../vehicles/coach.xml" count="3" spacing="26 m"/>)"),
          element<&Train::couplings>(
              "coupling",
              "A vertical spring and damper from the rear end of a carbody to the front end of the next; it carries no "
              "static load. One serves all; or one between each two vehicles, front to rear; without any, the vehicles "
              "run uncoupled.",
              R"(<coupling stiffness_z="50 kN/m" damping_z="20 kN*s/m" end_x="12.5 m"/>)"),
      });
}

}  // namespace vehicle::schema
