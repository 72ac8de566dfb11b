#include "libvehicle/linear/mode_following.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>

#include "libvehicle/linear/branches.h"
#include "libvehicle/linear/root_groups.h"
#include "libvehicle/linear/state_scaling.h"
#include "libvehicle/linear/whole_modes.h"

namespace vehicle {

namespace {

using Fate = FollowedMode::Fate;
using Groups = std::vector<RootGroup>;

// A step that is no clearer than its halves: what meets there meets in one point.
constexpr double kShortestStep = 1.0 / (1 << 20);
// Roots that coincide and part without clear shapes are looked at from this near.
constexpr double kShortStep = 1.0 / (1 << 6);

/// One way along a path.
class Walk {
 public:
  Walk(const MatrixPath& path, const Eigen::VectorXd& units, const std::vector<WholeMode>& modes)
      : path_(path), units_(units), modes_(modes), reasons_(modes.size()) {}

  [[nodiscard]] Groups groupsAt(double t) const { return rootGroupsOf(inUnits(path_(t), units_)); }

  /// @param end  the groups at t1
  std::vector<Branch> go(const std::vector<Branch>& from, double t0, double t1, const Groups& end) {
    const double middle = 0.5 * (t0 + t1);
    const Groups between = groupsAt(middle);
    // A step may hide what happens in it. One that says what its halves say hides nothing that they would show.
    const Doubt doubt = t1 - t0 <= kShortStep ? Doubt::kOrder : Doubt::kRefuse;
    const auto whole = advance(from, end, doubt);
    const auto half = advance(from, between, doubt);
    if (whole && half) {
      auto both = advance(*half, end, doubt);
      if (both && sameOwners(*both, *whole)) return *std::move(both);
    }
    if (t1 - t0 <= kShortestStep) {
      std::vector<Branch> next = *advance(from, end, Doubt::kLose);
      explain(from, next);
      return next;
    }
    return go(go(from, t0, middle, between), middle, t1, end);
  }

  [[nodiscard]] const std::string& reason(std::size_t mode) const { return reasons_[mode]; }

 private:
  static std::set<int> ownersOf(const std::vector<Branch>& branches) {
    std::set<int> owners;
    for (const Branch& each : branches) owners.insert(each.owners.begin(), each.owners.end());
    owners.erase(kNobody);
    return owners;
  }

  /// Says why modes that had a branch have none any more.
  void explain(const std::vector<Branch>& before, const std::vector<Branch>& after) {
    std::set<int> lost = ownersOf(before);
    for (const int each : ownersOf(after)) lost.erase(each);
    for (const int mode : lost) {
      std::string others;
      for (const int other : lost) {
        if (other == mode) continue;
        if (!others.empty()) others.append(", ");
        others.append(modes_[static_cast<std::size_t>(other)].names.front());
      }
      std::string& reason = reasons_[static_cast<std::size_t>(mode)];
      reason = others.empty() ? "its shape changes at once" : "its roots meet in one point those of ";
      reason.append(others);
    }
  }

  const MatrixPath& path_;
  const Eigen::VectorXd& units_;
  const std::vector<WholeMode>& modes_;
  std::vector<std::string> reasons_;
};

/// Modes of a matrix, given away one by one.
class RootSupply {
 public:
  explicit RootSupply(std::vector<Mode> modes) : modes_(std::move(modes)), used_(modes_.size(), 0) {}

  /// The one nearest to the value; of equal ones one that is not given away yet.
  const Mode& take(std::complex<double> value) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < modes_.size(); ++i) {
      const double nearer = std::abs(modes_[best].eigenvalue - value) - std::abs(modes_[i].eigenvalue - value);
      const bool same = std::abs(nearer) <= kSameRoot * std::abs(value);
      if (same ? used_[i] < used_[best] : nearer > 0.0) best = i;
    }
    ++used_[best];
    return modes_[best];
  }

 private:
  std::vector<Mode> modes_;
  std::vector<int> used_;
};

std::vector<FollowedMode> fatesOf(const std::vector<Branch>& branches, const std::vector<WholeMode>& modes,
                                  const Walk& walk, RootSupply supply) {
  std::vector<FollowedMode> fates(modes.size());
  for (const Branch& branch : branches) {
    const Mode& root = supply.take(branch.value);
    const std::set<int> owners(branch.owners.begin(), branch.owners.end());
    for (const int owner : owners) {
      if (owner == kNobody) continue;
      FollowedMode& fate = fates[static_cast<std::size_t>(owner)];
      if (owners.size() == 1) {
        fate.roots.push_back(root);
        continue;
      }
      const int other = owner == *owners.begin() ? *owners.rbegin() : *owners.begin();
      fate.reason = "one of its two real roots has become an oscillation with one of " +
                    (other == kNobody ? "another mode" : modes[static_cast<std::size_t>(other)].names.front());
    }
  }
  for (std::size_t i = 0; i < fates.size(); ++i) {
    FollowedMode& fate = fates[i];
    if (fate.reason.empty() && fate.roots.empty()) fate.reason = walk.reason(i);
    if (!fate.reason.empty() || fate.roots.empty()) {
      fate.roots.clear();
      if (fate.reason.empty()) fate.reason = "its roots coincide with fewer shapes than roots";
      continue;
    }
    std::sort(fate.roots.begin(), fate.roots.end(),
              [](const Mode& a, const Mode& b) { return std::abs(a.eigenvalue) < std::abs(b.eigenvalue); });
    const bool oscillates = fate.roots.front().eigenvalue.imag() > 0.0;
    fate.fate = oscillates ? Fate::kOscillates : Fate::kAperiodic;
    if (oscillates) fate.roots.resize(1);
  }
  return fates;
}

}  // namespace

struct ModeFollower::Start {
  std::vector<Branch> branches;
};

ModeFollower::ModeFollower(const Eigen::MatrixXd& A, const std::vector<Channel>& states)
    : states_(states), modes_(wholeModesOf(A, states)) {
  units_ = stateUnits(A);
  start_ = std::make_shared<const Start>(Start{firstBranches(modes_, rootGroupsOf(inUnits(A, units_)), units_)});
}

std::optional<std::size_t> ModeFollower::find(std::string_view name) const {
  // What a root is called first: "carbody pitch" may oscillate beside a "carbody pitch, aperiodic".
  for (const bool of_root : {true, false}) {
    for (std::size_t i = 0; i < modes_.size(); ++i) {
      const auto& names = modes_[i].names;
      if (of_root ? std::find(names.begin() + 1, names.end(), name) != names.end() : names.front() == name) return i;
    }
  }
  return std::nullopt;
}

std::vector<FollowedMode> ModeFollower::follow(const MatrixPath& path) const {
  const double end = 1.0;
  return std::move(follow(path, std::span(&end, 1)).front());
}

std::vector<std::vector<FollowedMode>> ModeFollower::follow(const MatrixPath& path,
                                                            std::span<const double> stops) const {
  Walk walk(path, units_, modes_);
  std::vector<std::vector<FollowedMode>> fates;
  std::vector<Branch> branches = start_->branches;
  double t = 0.0;
  for (const double stop : stops) {
    if (!(stop > t) || stop > 1.0) throw std::invalid_argument("mode following: stops must rise, within 0 < t <= 1");
    const Eigen::MatrixXd A = path(stop);
    branches = walk.go(branches, t, stop, rootGroupsOf(inUnits(A, units_)));
    t = stop;
    fates.push_back(fatesOf(branches, modes_, walk, RootSupply(modesOf(A, states_))));
  }
  return fates;
}

std::optional<double> FollowedMode::frequency() const {
  if (fate != Fate::kOscillates) return std::nullopt;
  return roots.front().frequency;
}

std::optional<double> FollowedMode::dampedFrequency() const {
  if (fate != Fate::kOscillates) return std::nullopt;
  return roots.front().eigenvalue.imag() / (2.0 * std::numbers::pi);
}

std::optional<double> FollowedMode::dampingRatio() const {
  if (fate == Fate::kOscillates) return roots.front().damping_ratio;
  if (fate == Fate::kLost) return std::nullopt;
  const bool both = roots.size() == 2 || roots.front().multiplicity > 1;
  const double slow = roots.front().eigenvalue.real();
  const double fast = roots.back().eigenvalue.real();
  if (!both || !(slow < 0.0) || !(fast < 0.0)) return std::nullopt;
  return -(slow + fast) / (2.0 * std::sqrt(slow * fast));
}

std::string FollowedMode::whyNoFrequency() const {
  if (fate == Fate::kOscillates) return "";
  if (fate == Fate::kLost) return "the mode is lost on the way from the base: " + reason;
  const auto any = [&](auto is) {
    return std::any_of(roots.begin(), roots.end(), [&](const Mode& each) { return is(each.eigenvalue.real()); });
  };
  if (any([](double root) { return root > 0.0; })) return "the mode grows without oscillating: its roots are real";
  if (any([](double root) { return root == 0.0; })) return "the mode is free: nothing holds it, it does not oscillate";
  return "the mode is overdamped: its roots are real, it does not oscillate";
}

}  // namespace vehicle
