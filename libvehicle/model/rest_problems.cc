#include "libvehicle/model/rest_problems.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "libvehicle/definition/judge.h"

namespace vehicle {
namespace {

// Preloads copied from a drawing carry six digits; a weight that is really uncarried is off by orders more.
constexpr double kBalance = 1e-6;
// What the solution's rounding may leave, as a share of the whole weight (and of weight * length): some 1e-16 are
// usual, and a body that nothing carries weighs more than a billionth of its vehicle.
constexpr double kRounding = 1e-9;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

std::string number(double value) {
  std::ostringstream text;
  text.precision(6);
  text << value;
  return text.str();
}

template <class Part>
Problem problem(const char* kind, const Part& part, std::string message, std::string remedy) {
  return {part.origin, std::string("<vehicle><") + kind + " name=\"" + part.name + "\">", std::move(message),
          std::move(remedy)};
}

/// What is too small to be an imbalance [N, N m] (q). A spring without load at the end of a long lever leaves 1e-10 N m
/// of a vehicle of 1 MN: its own loads are no measure of that.
Eigen::VectorXd smallest(const Topology& topology, double gravity, const RestBalance& balance,
                         const RestSolution& solved) {
  double weight = 0.0;
  double length = 0.0;
  for (const TopologyBody& body : topology.bodies) weight += body.mass * gravity;
  for (const TopologyWheelset& wheelset : topology.wheelsets) weight += wheelset.mass * gravity;
  Eigen::VectorXd own = solved.given.cwiseAbs();
  for (std::size_t s = 0; s < balance.springs.size(); ++s) {
    const TopologySuspension& each = topology.suspensions[s];
    length = std::max({length, std::abs(each.arm_upper), std::abs(each.arm_lower)});
    own += std::abs(solved.spring_load[s]) * balance.springs[s].row.cwiseAbs();
  }
  Eigen::VectorXd rounding = Eigen::VectorXd::Constant(own.size(), kRounding * weight);
  for (const TopologyBody& body : topology.bodies) {
    if (body.pitch_index >= 0) rounding[body.pitch_index] *= length;
  }
  return (kBalance * own).cwiseMax(rounding);
}

class Uncarried {
 public:
  Uncarried(const Topology& topology, double gravity, const RestBalance& balance, const RestSolution& solved)
      : topology_(topology),
        balance_(balance),
        left_(solved.left),
        smallest_(smallest(topology, gravity, balance, solved)) {}

  ProblemList run() {
    for (std::size_t s = 0; s < balance_.springs.size(); ++s) reportPreload(s);
    for (const TopologyBody& body : topology_.bodies) report("body", body, body.z_index, body.pitch_index);
    for (const TopologyWheelset& wheelset : topology_.wheelsets) report("wheelset", wheelset, wheelset.z_index, -1);
    return std::move(problems_);
  }

 private:
  [[nodiscard]] bool isOpen(int index) const { return index >= 0 && std::abs(left_[index]) > smallest_[index]; }

  /// Two bodies that miss the same force in opposite directions have one mistake between them.
  void reportPreload(std::size_t s) {
    const TopologySuspension& each = topology_.suspensions[s];
    if (!each.preload || each.lower_body < 0) return;
    const TopologyBody& upper = topology_.bodies[at(each.upper)];
    const TopologyBody& lower = topology_.bodies[at(each.lower_body)];
    if (!isOpen(upper.z_index) || !isOpen(lower.z_index)) return;
    const double missing = left_[upper.z_index];
    if (std::abs(missing + left_[lower.z_index]) > smallest_[upper.z_index] + smallest_[lower.z_index]) return;
    left_ -= missing * balance_.springs[s].row;
    ProblemList none;
    const Judge judge(none, "", "", each.origin);
    problems_.add(problem("suspension", each,
                          judge.written("preload", *each.preload, Dimension::kForce) + " leaves a vertical force of " +
                              number(missing) + " N on \"" + upper.name + "\" and the opposite on \"" + lower.name +
                              "\"; the weight must be carried",
                          "a preload of " + number(*each.preload - missing) + " N balances both, or leave it out"));
  }

  template <class Part>
  void report(const char* kind, const Part& part, int z, int pitch) {
    std::string what;
    if (isOpen(z)) what = "a vertical force of " + number(left_[z]) + " N";
    if (isOpen(pitch)) {
      what += (what.empty() ? "" : " and ") + ("a pitch moment of " + number(left_[pitch]) + " N m");
    }
    if (what.empty()) return;
    problems_.add(problem(kind, part,
                          "springs and preloads leave " + what + " at rest; " +
                              (isOpen(z) ? "the weight must be carried" : "moments must balance"),
                          "give the springs under it a stiffness, or leave out one of the preloads"));
  }

  const Topology& topology_;
  const RestBalance& balance_;
  Eigen::VectorXd left_;
  Eigen::VectorXd smallest_;
  ProblemList problems_;
};

}  // namespace

ProblemList uncarried(const Topology& topology, double gravity, const RestBalance& balance,
                      const RestSolution& solved) {
  return Uncarried(topology, gravity, balance, solved).run();
}

// A centre of gravity outside the wheelsets lifts all wheels at the other end: that is one problem, at the lightest.
ProblemList wheelsOffTheRail(const Topology& topology, const std::vector<double>& wheel_load) {
  double total = 0.0;
  for (const double load : wheel_load) total += std::abs(load);
  std::size_t lightest = 0;
  int lifted = 0;
  std::vector<const TopologyWheelset*> soft;
  for (std::size_t j = 0; j < wheel_load.size(); ++j) {
    const TopologyWheelset& wheelset = topology.wheelsets[j];
    if (wheel_load[j] < wheel_load[lightest]) lightest = j;
    if (wheel_load[j] < -kBalance * total) {
      ++lifted;
    } else if (wheelset.z_index >= 0 && !wheelset.contact_stiffness && !(wheel_load[j] > kBalance * total)) {
      soft.push_back(&wheelset);
    }
  }
  ProblemList problems;
  const auto ofSeveral = [](std::size_t count) {
    return count == 1 ? std::string() : " (so it is with " + std::to_string(count) + " wheelsets of the vehicle)";
  };
  if (lifted > 0) {
    problems.add(problem("wheelset", topology.wheelsets[lightest],
                         "its static wheel load would be " + number(wheel_load[lightest]) + " N; a rail can only push" +
                             ofSeveral(static_cast<std::size_t>(lifted)),
                         "move the centre of gravity between the wheelsets, or give its load"));
  } else if (!soft.empty()) {
    problems.add(problem("wheelset", *soft.front(),
                         "a Hertz contact without static load has no stiffness" + ofSeveral(soft.size()),
                         "set gravity > 0, or give its load or contact_stiffness"));
  }
  return problems;
}

}  // namespace vehicle
