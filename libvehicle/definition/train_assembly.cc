#include <string>
#include <utility>

#include "libvehicle/definition/judge.h"
#include "libvehicle/definition/train.h"
#include "libvehicle/definition/train_part.h"

// A train made one vehicle.
namespace vehicle {

namespace {

class Assembler {
 public:
  explicit Assembler(const Train& train) : train_(train) {
    made_.name = train.name;
    made_.title = train.title;
    made_.source = train.source;
    made_.origin = train.origin;
  }

  Vehicle run() {
    const TrainVehicle* ahead = nullptr;
    double x = 0.0;
    for (const TrainVehicle& each : train_.vehicles) {
      const int carbody = carbodyOf(each.vehicle);
      for (int k = 0; k < each.count; ++k, ahead = &each) {
        if (ahead != nullptr) x -= shiftBetween(*ahead, each);
        addUnit(each, x);
        if (train_.couplings.empty()) continue;
        const Body& body = each.vehicle.bodies[static_cast<std::size_t>(carbody)];
        carbodies_.push_back({prefix_ + body.name, x + bodyX(each.vehicle, body), body.z, each.end_x});
      }
    }
    if (!train_.couplings.empty()) addCouplings();
    return std::move(made_);
  }

 private:
  struct Carbody {
    std::string name;
    double x = 0.0;
    std::optional<double> z;
    std::optional<double> end_x;
  };

  void addUnit(const TrainVehicle& each, double x) {
    const std::string name = unitName(each) + '_' + std::to_string(made_.units.size() + 1);
    made_.units.push_back({name, each.vehicle.title, x, each.origin});
    prefix_ = name + '.';
    const Vehicle& from = each.vehicle;
    for (Element element : from.elements) {
      element.name = prefix_ + element.name;
      made_.elements.push_back(std::move(element));
    }
    for (Group group : from.groups) {
      group.name = prefix_ + group.name;
      group.x += x;
      made_.groups.push_back(std::move(group));
    }
    add(from.bodies, made_.bodies, x);
    add(from.wheelsets, made_.wheelsets, x);
    for (Suspension suspension : from.suspensions) {
      suspension.element = prefix_ + suspension.element;
      suspension.upper = prefix_ + suspension.upper;
      suspension.lower = prefix_ + suspension.lower;
      if (suspension.x_lower && suspension.group.empty()) *suspension.x_lower += x;
      made_.suspensions.push_back(placed(std::move(suspension), x));
    }
    for (Point point : from.points) {
      point.body = prefix_ + point.body;
      made_.points.push_back(placed(std::move(point), x));
    }
  }

  template <class Part>
  void add(const std::vector<Part>& from, std::vector<Part>& to, double x) {
    for (const Part& part : from) to.push_back(placed(part, x));
  }

  /// The part in its unit: what stands in a group moves with the group.
  template <class Part>
  [[nodiscard]] Part placed(Part part, double x) const {
    part.name = prefix_ + part.name;
    if (part.group.empty()) {
      part.x += x;
    } else {
      part.group = prefix_ + part.group;
    }
    return part;
  }

  void addCouplings() {
    const bool one_for_all = train_.couplings.size() == 1;
    for (std::size_t gap = 0; gap + 1 < carbodies_.size(); ++gap) {
      const Coupling& coupling = *couplingAt(train_, gap);
      const std::string number = std::to_string(gap + 1);
      const std::string element = one_for_all ? "coupling" : "coupling_element_" + number;
      if (gap == 0 || !one_for_all) {
        made_.elements.push_back({element, coupling.stiffness_z, coupling.damping_z, {}, coupling.origin});
      }
      const Carbody& ahead = carbodies_[gap];
      const Carbody& behind = carbodies_[gap + 1];
      Suspension suspension;
      suspension.name = "coupling_" + number;
      suspension.element = element;
      suspension.upper = ahead.name;
      suspension.lower = behind.name;
      suspension.x = ahead.x - *(ahead.end_x ? ahead.end_x : coupling.end_x);
      suspension.x_lower = behind.x + *(behind.end_x ? behind.end_x : coupling.end_x);
      suspension.z_upper = coupling.z ? coupling.z : ahead.z;
      suspension.z_lower = coupling.z ? coupling.z : behind.z;
      suspension.preload = 0.0;
      suspension.origin = coupling.origin;
      made_.suspensions.push_back(std::move(suspension));
    }
  }

  const Train& train_;
  Vehicle made_;
  std::string prefix_;  // of the unit at hand
  std::vector<Carbody> carbodies_;
};

}  // namespace

Vehicle assembled(const Train& train) {
  ProblemList problems = check(train);
  for (const TrainVehicle& each : train.vehicles) {
    if (isRead(each)) continue;
    Judge(problems, "<train><vehicle>", "", each.origin)
        .say(quotedName(each) + " has not been read", "read the vehicle files before the train is assembled");
  }
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  return Assembler(train).run();
}

}  // namespace vehicle
