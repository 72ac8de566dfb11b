#include "libvehicle/flat/flat_layout.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Names in quotes, comma between.
template <class Part>
std::string namesOf(const std::vector<Part>& parts, const std::vector<int>& indices) {
  std::string text;
  for (const int index : indices) text += fmt::format("{}\"{}\"", text.empty() ? "" : ", ", parts[at(index)].name);
  return text;
}

/// The part by name, also where the file's line is known: the message then reads as a sentence about it.
std::string pathOfPart(const char* kind, const std::string& name) {
  return fmt::format("<vehicle><{} name=\"{}\">", kind, name);
}

const std::string kOtherForm = "take the form matrix, which computes any vehicle";

/// Reads a layout part by part and notes what does not fit.
class Reader {
 public:
  explicit Reader(const Topology& topology) : topology_(topology) {}

  FlatReading read() {
    sortSuspensions();
    if (!findCarbody()) return std::move(reading_);
    std::vector<int> bogies = findBogies();
    std::stable_sort(bogies.begin(), bogies.end(),
                     [&](int a, int b) { return topology_.bodies[at(a)].x > topology_.bodies[at(b)].x; });
    for (std::size_t i = 0; i < bogies.size(); ++i) readBogie(bogies[i], i);
    readWheelsets();
    reading_.problems.sortByPlace();
    return std::move(reading_);
  }

 private:
  void unsupported(const Place& place, const char* element, const std::string& name, const std::string& message,
                   const std::string& remedy = kOtherForm) {
    reading_.problems.add({place, pathOfPart(element, name), message, remedy});
  }
  void reportBody(int body, const std::string& message, const std::string& remedy = kOtherForm) {
    unsupported(topology_.bodies[at(body)].origin, "body", topology_.bodies[at(body)].name, message, remedy);
  }
  void reportSuspension(int suspension, const std::string& message) {
    unsupported(topology_.suspensions[at(suspension)].origin, "suspension", topology_.suspensions[at(suspension)].name,
                message);
  }

  void sortSuspensions() {
    under_.resize(topology_.bodies.size());
    over_.resize(topology_.bodies.size());
    on_wheels_.resize(topology_.bodies.size());
    for (std::size_t s = 0; s < topology_.suspensions.size(); ++s) {
      const TopologySuspension& suspension = topology_.suspensions[s];
      if (suspension.lower_body >= 0) {
        under_[at(suspension.upper)].push_back(static_cast<int>(s));
        over_[at(suspension.lower_body)].push_back(static_cast<int>(s));
      } else {
        on_wheels_[at(suspension.upper)].push_back(static_cast<int>(s));
      }
    }
  }

  bool findCarbody() {
    for (std::size_t b = 0; b < topology_.bodies.size(); ++b) {
      if (under_[b].empty() || !over_[b].empty()) continue;
      if (reading_.layout.carbody < 0) {
        reading_.layout.carbody = static_cast<int>(b);
      } else {
        reportBody(static_cast<int>(b),
                   fmt::format("is a second carbody beside \"{}\"; the form flat computes one carbody",
                               topology_.bodies[at(reading_.layout.carbody)].name));
      }
    }
    if (reading_.layout.carbody < 0) {
      reading_.problems.add({topology_.origin, fmt::format("<vehicle name=\"{}\">", topology_.name),
                             "has no body that stands on other bodies; the form flat computes a carbody on two bogies",
                             kOtherForm});
      return false;
    }
    const TopologyBody& carbody = topology_.bodies[at(reading_.layout.carbody)];
    if (carbody.z_index < 0 || carbody.pitch_index < 0) {
      reportBody(reading_.layout.carbody,
                 fmt::format("moves in {} only; the form flat computes z and pitch of the carbody",
                             carbody.z_index < 0 ? "pitch" : "z"),
                 "take the form matrix, or write motion=\"z pitch\" with a pitch_inertia");
    }
    for (const int s : on_wheels_[at(reading_.layout.carbody)]) {
      reportSuspension(
          s,
          fmt::format("joins the carbody \"{}\" to a wheelset; the form flat computes carbodies that stand on bogies",
                      carbody.name));
    }
    return true;
  }

  std::vector<int> findBogies() {
    std::vector<int> bogies;
    for (std::size_t b = 0; b < topology_.bodies.size(); ++b) {
      const bool carried = std::any_of(over_[b].begin(), over_[b].end(), [&](int s) {
        return topology_.suspensions[at(s)].upper == reading_.layout.carbody;
      });
      if (carried) {
        bogies.push_back(static_cast<int>(b));
      } else if (static_cast<int>(b) != reading_.layout.carbody && (under_[b].empty() || !over_[b].empty())) {
        reportBody(static_cast<int>(b),
                   "is neither the carbody nor a bogie under it; the form flat computes no other body");
      }
    }
    if (bogies.size() != 2) {
      reportBody(reading_.layout.carbody,
                 fmt::format("stands on {} {} ({}); the form flat computes two", bogies.size(),
                             bogies.size() == 1 ? "bogie" : "bogies", namesOf(topology_.bodies, bogies)));
    }
    return bogies;
  }

  void readBogie(int index, std::size_t place) {
    const TopologyBody& bogie = topology_.bodies[at(index)];
    if (bogie.pitch_index >= 0) {
      reportBody(index, "has a pitch motion; the form flat computes the bounce of a bogie and no pitch",
                 "take the form matrix, which computes both");
    } else if (bogie.z_index < 0) {
      reportBody(index, "has no z motion; the form flat computes bogies that move in z");
    }
    const std::vector<int>& secondaries = over_[at(index)];
    if (secondaries.size() != 1) {
      reportBody(index, fmt::format("carries bodies by {} suspensions ({}); the form flat computes one for each bogie",
                                    secondaries.size(), namesOf(topology_.suspensions, secondaries)));
    }
    for (const int s : under_[at(index)]) {
      reportSuspension(
          s,
          fmt::format("joins the bogie \"{}\" to another body; the form flat computes bogies that stand on wheelsets",
                      bogie.name));
    }
    std::vector<int> primaries = on_wheels_[at(index)];
    const auto wheel = [&](int s) { return topology_.suspensions[at(s)].lower_wheelset; };
    if (primaries.size() != 2) {
      reportBody(
          index,
          fmt::format("stands on wheelsets by {} suspension{} ({}); the form flat computes two for each bogie",
                      primaries.size(), primaries.size() == 1 ? "" : "s", namesOf(topology_.suspensions, primaries)));
      return;
    }
    if (wheel(primaries[0]) == wheel(primaries[1])) {
      reportBody(index,
                 fmt::format("stands on the wheelset \"{}\" twice; the form flat computes two wheelsets for each bogie",
                             topology_.wheelsets[at(wheel(primaries[0]))].name));
      return;
    }
    if (place >= 2) return;
    std::stable_sort(primaries.begin(), primaries.end(), [&](int a, int b) {
      return topology_.wheelsets[at(wheel(a))].x > topology_.wheelsets[at(wheel(b))].x;
    });
    FlatLayout& layout = reading_.layout;
    layout.bogie[place] = index;
    layout.secondary[place] = secondaries[0];
    for (std::size_t axle = 0; axle < 2; ++axle) {
      layout.primary[2 * place + axle] = primaries[axle];
      layout.wheelset[2 * place + axle] = wheel(primaries[axle]);
    }
  }

  void readWheelsets() {
    for (std::size_t j = 0; j < topology_.wheelsets.size(); ++j) {
      const TopologyWheelset& wheelset = topology_.wheelsets[j];
      const Place& place = wheelset.origin;
      if (wheelset.z_index >= 0) {
        unsupported(
            place, "wheelset", wheelset.name,
            "has mass and contact, and so a motion of its own; the form flat computes wheelsets that follow the rail",
            "take the form matrix, or remove the contact");
      }
      std::vector<int> carried;
      for (const TopologySuspension& suspension : topology_.suspensions) {
        if (suspension.lower_wheelset == static_cast<int>(j) &&
            std::find(carried.begin(), carried.end(), suspension.upper) == carried.end()) {
          carried.push_back(suspension.upper);
        }
      }
      if (carried.size() != 1) {
        unsupported(
            place, "wheelset", wheelset.name,
            carried.empty()
                ? std::string("carries nothing; the form flat computes wheelsets that carry one bogie each")
                : fmt::format("carries {} bodies ({}); the form flat computes wheelsets that carry one bogie each",
                              carried.size(), namesOf(topology_.bodies, carried)));
      }
    }
  }

  const Topology& topology_;
  FlatReading reading_;
  std::vector<std::vector<int>> under_;      // (bodies) suspensions from this body down to bodies
  std::vector<std::vector<int>> over_;       // (bodies) suspensions from bodies above down to this one
  std::vector<std::vector<int>> on_wheels_;  // (bodies) suspensions from this body to wheelsets
};

}  // namespace

FlatReading readLayout(const Topology& topology) { return Reader(topology).read(); }

ProblemList asymmetries(const Topology& topology, const FlatLayout& layout) {
  // Places are sums and differences of the file's numbers: arms that are equal on paper may differ by roundings.
  constexpr double kEqual = 1e-9;
  const std::string remedy = "give both the same, or take the form flat";
  ProblemList problems;
  const auto compare = [&](const Place& place, const char* element, const std::string& name, const char* what,
                           double value, const std::string& model_name, double model, const char* unit) {
    if (std::abs(value - model) <= kEqual * std::max(std::abs(value), std::abs(model))) return;
    problems.add({place, pathOfPart(element, name),
                  fmt::format("has {} {:.10g} {}, \"{}\" has {:.10g} {}; the printed equations have one value for both",
                              what, value, unit, model_name, model, unit),
                  remedy});
  };
  const auto compareSuspension = [&](int index, int model_index) {
    const TopologySuspension& one = topology.suspensions[at(index)];
    const TopologySuspension& model = topology.suspensions[at(model_index)];
    const Place& place = one.origin;
    compare(place, "suspension", one.name, "stiffness", one.stiffness, model.name, model.stiffness, "N/m");
    compare(place, "suspension", one.name, "damping", one.damping, model.name, model.damping, "N*s/m");
  };
  const TopologyBody& front = topology.bodies[at(layout.bogie[0])];
  const TopologyBody& rear = topology.bodies[at(layout.bogie[1])];
  compare(rear.origin, "body", rear.name, "mass", rear.mass, front.name, front.mass, "kg");
  compareSuspension(layout.secondary[1], layout.secondary[0]);
  const TopologySuspension& ahead = topology.suspensions[at(layout.secondary[0])];
  const TopologySuspension& behind = topology.suspensions[at(layout.secondary[1])];
  const double lf = ahead.arm_upper;
  const double lr = -behind.arm_upper;
  if (std::abs(lf - lr) > kEqual * std::max(std::abs(lf), std::abs(lr))) {
    problems.add({behind.origin, pathOfPart("suspension", behind.name),
                  fmt::format("stands {:.10g} m behind the carbody's centre of gravity, \"{}\" {:.10g} m ahead; the "
                              "printed equations have one lever arm for both",
                              lr, ahead.name, lf),
                  remedy});
  }
  for (std::size_t wheel = 1; wheel < 4; ++wheel) compareSuspension(layout.primary[wheel], layout.primary[0]);
  for (const int secondary : layout.secondary) {
    const TopologySuspension& suspension = topology.suspensions[at(secondary)];
    if (suspension.height_upper == 0.0) continue;
    problems.add({suspension.origin, pathOfPart("suspension", suspension.name),
                  fmt::format("ends {:g} m {} the carbody's centre of gravity; the printed equations carry no "
                              "static loads at heights",
                              std::abs(suspension.height_upper), suspension.height_upper < 0.0 ? "below" : "above"),
                  "remove the heights, or take the form flat"});
  }
  problems.sortByPlace();
  return problems;
}

}  // namespace vehicle
