#include "libvehicle/definition/train.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "libvehicle/definition/judge.h"
#include "libvehicle/definition/train_attributes.h"
#include "libvehicle/definition/train_part.h"

namespace vehicle {

namespace {

constexpr double kTouching = 1e-9;  // [m] ends that only rounding drives into each other

bool hasHeights(const Vehicle& vehicle) {
  return std::any_of(vehicle.bodies.begin(), vehicle.bodies.end(), [](const Body& body) { return body.z.has_value(); });
}

/// Two units that follow each other: indices into train.vehicles, and the number of the gap between them.
struct Neighbours {
  std::size_t ahead = 0;
  std::size_t behind = 0;
  std::size_t gap = 0;
};

std::vector<Neighbours> neighboursOf(const Train& train) {
  std::vector<Neighbours> all;
  std::size_t gap = 0;
  for (std::size_t i = 0; i < train.vehicles.size(); ++i) {
    if (i > 0) all.push_back({i - 1, i, gap++});
    for (int k = 1; k < train.vehicles[i].count; ++k) all.push_back({i, i, gap++});
  }
  return all;
}

class TrainCheck {
 public:
  explicit TrainCheck(const Train& train) : train_(train) {}

  ProblemList run() {
    checkWhole();
    for (const TrainVehicle& each : train_.vehicles) checkVehicle(each);
    for (const Coupling& each : train_.couplings) checkCoupling(each);
    checkHeights();
    if (values_hold_) checkEnds();
    problems_.sortByPlace();
    return std::move(problems_);
  }

 private:
  Judge judgeOf(const TrainVehicle& each) {
    return Judge(problems_, "<train><vehicle>", each.origin.line == 0 ? unitName(each) : "", each.origin);
  }
  Judge judgeOf(const Coupling& each) { return Judge(problems_, "<train><coupling>", "", each.origin); }

  void checkWhole() {
    Judge judge(problems_, "<train>", train_.name, train_.origin);
    judge.properName(train_.name);
    if (train_.vehicles.empty() && !train_.origin.hasStrange()) {
      judge.say("has no <vehicle>", "a train has at least one");
    }
    const bool counted = std::all_of(train_.vehicles.begin(), train_.vehicles.end(),
                                     [](const TrainVehicle& each) { return each.origin.knows("count"); });
    values_hold_ = counted && !train_.origin.hasStrange();
    if (!values_hold_) return;
    const long vehicles = vehiclesOf(train_);
    if (vehicles > Train::kMostVehicles) {
      judge.say("has " + std::to_string(vehicles) + " vehicles",
                "must be at most " + std::to_string(Train::kMostVehicles));
      values_hold_ = false;
    }
    const auto couplings = static_cast<long>(train_.couplings.size());
    if (couplings > 1 && couplings != vehicles - 1) {
      judge.say("has " + std::to_string(couplings) + " couplings between " + std::to_string(vehicles) + " vehicles",
                "give one <coupling> for all, or " + std::to_string(std::max(0L, vehicles - 1)) +
                    " of them from front to rear");
      values_hold_ = false;
    }
  }

  void checkVehicle(const TrainVehicle& each) {
    Judge judge = judgeOf(each);
    if (each.file.empty() && !isRead(each) && judge.knows({"file"})) judge.say("file is empty", "name a file, e.g. file=\"coach.xml\"");
    if (!each.name.empty()) judge.properName(each.name);
    if (each.count < 1 && judge.knows({"count"})) {
      judge.say(judge.written("count", each.count), "must be >= 1");
      values_hold_ = false;
    }
    const bool spacing = judge.number<&TrainVehicle::spacing>(each);
    const bool end = judge.number<&TrainVehicle::end_x>(each);
    judge.numbers<&TrainVehicle::spacing, &TrainVehicle::end_x>(each);
    values_hold_ = values_hold_ && spacing && end;
    if (!isRead(each)) return;
    if (!each.vehicle.units.empty()) judge.say(quotedName(each) + " is a train itself", "list its vehicles one by one");
    const ProblemList own = check(each.vehicle);
    problems_.append(own);
    values_hold_ = values_hold_ && own.empty() && each.vehicle.units.empty();
    if (train_.couplings.empty() || carbodyOf(each.vehicle) >= 0) return;
    judge.say(quotedName(each) + " has no carbody to couple: not just one of its bodies is without another above it",
              "leave the <coupling> out, or let one body alone stand on top");
    values_hold_ = false;
  }

  void checkCoupling(const Coupling& each) {
    Judge judge = judgeOf(each);
    judge.numbers<&Coupling::end_x, &Coupling::z>(each);
    const bool end = judge.number<&Coupling::end_x>(each);
    values_hold_ = values_hold_ && judge.number<&Coupling::z>(each) && end;
  }

  void checkHeights() {
    if (train_.vehicles.empty()) return;
    const TrainVehicle* with = nullptr;
    const TrainVehicle* without = nullptr;
    for (const TrainVehicle& each : train_.vehicles) {
      if (!isRead(each)) return;
      const TrainVehicle*& first = hasHeights(each.vehicle) ? with : without;
      if (first == nullptr) first = &each;
    }
    if (with != nullptr && without != nullptr) {
      judgeOf(*without).say(
          quotedName(*without) + " has no heights, but " + quotedName(*with) + inLine(with->origin) + " has some",
          "heights are given for all vehicles of a train or for none");
    }
    if (with != nullptr) return;
    for (const Coupling& each : train_.couplings) {
      if (!each.z || !each.origin.knows("z")) continue;
      Judge judge = judgeOf(each);
      judge.say(judge.written("z", *each.z, Dimension::kLength) + ", but the vehicles have no heights",
                "leave z out, or give the vehicles heights");
    }
  }

  /// Every coupled carbody has ends, and neighbours do not stand into each other. Equal neighbours are told once.
  void checkEnds() {
    std::set<const TrainVehicle*> endless;
    std::set<std::pair<std::size_t, std::size_t>> seen;
    for (const Neighbours& pair : neighboursOf(train_)) {
      const Coupling* coupling = couplingAt(train_, pair.gap);
      if (coupling == nullptr) return;
      const TrainVehicle& ahead = train_.vehicles[pair.ahead];
      const TrainVehicle& behind = train_.vehicles[pair.behind];
      for (const TrainVehicle* each : {&ahead, &behind}) {
        const bool known = each->origin.knows("end_x") && coupling->origin.knows("end_x");
        if (each->end_x || coupling->end_x || !known || !endless.insert(each).second) continue;
        judgeOf(*each).say(
            quotedName(*each) + " has no end_x, and its coupling" + inLine(coupling->origin) + " has none",
            "give one of them, e.g. end_x=\"12.5 m\"");
      }
      const auto front = ahead.end_x ? ahead.end_x : coupling->end_x;
      const auto rear = behind.end_x ? behind.end_x : coupling->end_x;
      if (!front || !rear || !isRead(ahead) || !isRead(behind)) continue;
      const double gap = shiftBetween(ahead, behind) + carbodyX(ahead) - *front - carbodyX(behind) - *rear;
      if (gap >= -kTouching || !seen.emplace(pair.ahead, pair.behind).second) continue;
      judgeOf(behind).say("the ends of " + quotedName(ahead) + " and " + quotedName(behind) + " overlap by " +
                              formatQuantity(std::max(1.0, std::round(-1e3 * gap)) / 1e3, Dimension::kLength),
                          "take a larger spacing or a smaller end_x");
    }
  }

  static double carbodyX(const TrainVehicle& each) {
    return bodyX(each.vehicle, each.vehicle.bodies[static_cast<std::size_t>(carbodyOf(each.vehicle))]);
  }

  const Train& train_;
  ProblemList problems_;
  bool values_hold_ = true;  // as far as the comparison of neighbours needs them
};

}  // namespace

long vehiclesOf(const Train& train) {
  long count = 0;
  for (const TrainVehicle& each : train.vehicles) count += std::max(each.count, 0);
  return count;
}

int carbodyOf(const Vehicle& vehicle) {
  std::set<std::string_view> below;
  for (const Suspension& suspension : vehicle.suspensions) below.insert(suspension.lower);
  int top = -1;
  for (std::size_t i = 0; i < vehicle.bodies.size(); ++i) {
    if (below.contains(vehicle.bodies[i].name)) continue;
    if (top >= 0) return -1;
    top = static_cast<int>(i);
  }
  return top;
}

ProblemList check(const Train& train) { return TrainCheck(train).run(); }

}  // namespace vehicle
