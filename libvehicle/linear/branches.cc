#include "libvehicle/linear/branches.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "libvehicle/linear/complex_svd.h"
#include "libvehicle/system/dense_solvers.h"

namespace vehicle {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double kShares = 0.15;   // a smaller share is what shapes change by, not a partner
constexpr double kClear = 0.25;    // what a branch and its partners may share with others
constexpr double kCoupled = 1e-6;  // coupling relative to the frequency below which modes pass each other freely
constexpr double kFarApart = 4.0;  // distance in couplings from which shapes change little

/// Whose bases stand side by side, and where each begins.
struct Stack {
  Eigen::MatrixXcd right;
  Eigen::MatrixXcd left;
  std::vector<Index> begin;
};

template <class Parts>
Stack stackOf(const Parts& parts, Index n) {
  Stack stack{Eigen::MatrixXcd(n, n), Eigen::MatrixXcd(n, n), {}};
  Index at = 0;
  for (const auto& each : parts) {
    stack.begin.push_back(at);
    stack.right.middleCols(at, each.size()) = each.right;
    stack.left.middleRows(at, each.size()) = each.left;
    at += each.size();
  }
  return stack;
}

/// Distance of the straight line from a to b from 0.
double distanceOf(Complex a, Complex b) {
  const Complex along = b - a;
  const double length2 = std::norm(along);
  if (length2 == 0.0) return std::abs(a);
  const double t = std::clamp(-std::real(a * std::conj(along)) / length2, 0.0, 1.0);
  return std::abs(a + t * along);
}

class Step {
 public:
  Step(const std::vector<Branch>& branches, const std::vector<RootGroup>& groups)
      : branches_(branches), groups_(groups), share_(shares()) {}

  std::optional<std::vector<Branch>> take(Doubt doubt) {
    for (const Knot& knot : knots()) {
      if (isClear(knot) && tie(knot, doubt)) continue;
      if (doubt != Doubt::kLose) return std::nullopt;
      lose(knot);
    }
    if (doubt == Doubt::kLose) {
      loseTheRest();
    } else if (modesMeet()) {
      return std::nullopt;
    }
    return std::move(next_);
  }

 private:
  /// Branches and groups that share with each other and with nothing else.
  struct Knot {
    std::vector<std::size_t> branches;
    std::vector<std::size_t> groups;
  };

  [[nodiscard]] Eigen::MatrixXd shares() const {
    const Index n = branches_.front().right.rows();
    const Stack old = stackOf(branches_, n);
    const Stack now = stackOf(groups_, n);
    const Eigen::MatrixXcd there = old.left * now.right;
    const Eigen::MatrixXcd back = now.left * old.right;
    Eigen::MatrixXd share(branches_.size(), groups_.size());
    for (std::size_t b = 0; b < branches_.size(); ++b) {
      for (std::size_t h = 0; h < groups_.size(); ++h) {
        const auto block = there.block(old.begin[b], now.begin[h], branches_[b].size(), groups_[h].size());
        const auto other = back.block(now.begin[h], old.begin[b], groups_[h].size(), branches_[b].size());
        share(at(b), at(h)) = block.cwiseProduct(other.transpose()).sum().real();
      }
    }
    return share;
  }

  static Index at(std::size_t i) { return static_cast<Index>(i); }

  /// What they share, of what they could.
  [[nodiscard]] double relative(std::size_t b, std::size_t h) const {
    return std::abs(share_(at(b), at(h))) / static_cast<double>(std::min(branches_[b].size(), groups_[h].size()));
  }

  [[nodiscard]] std::vector<Knot> knots() const {
    std::vector<Knot> list;
    std::vector<bool> seen(groups_.size(), false);
    std::vector<bool> taken(branches_.size(), false);
    for (std::size_t first = 0; first < branches_.size(); ++first) {
      if (taken[first]) continue;
      taken[first] = true;
      Knot knot{{first}, {}};
      for (std::size_t i = 0; i < knot.branches.size(); ++i) {
        for (std::size_t h = 0; h < groups_.size(); ++h) {
          if (seen[h] || relative(knot.branches[i], h) < kShares) continue;
          seen[h] = true;
          knot.groups.push_back(h);
          for (std::size_t b = 0; b < branches_.size(); ++b) {
            if (taken[b] || relative(b, h) < kShares) continue;
            taken[b] = true;
            knot.branches.push_back(b);
          }
        }
      }
      std::sort(knot.branches.begin(), knot.branches.end());
      std::sort(knot.groups.begin(), knot.groups.end());
      list.push_back(std::move(knot));
    }
    return list;
  }

  /// Whether as many roots leave as come, and little is shared with others.
  [[nodiscard]] bool isClear(const Knot& knot) const {
    Index roots = 0;
    for (const std::size_t h : knot.groups) roots += groups_[h].size();
    for (const std::size_t b : knot.branches) roots -= branches_[b].size();
    if (roots != 0) return false;
    const auto within = [&](double sum, Index size) { return std::abs(sum - static_cast<double>(size)) < kClear; };
    for (const std::size_t b : knot.branches) {
      double sum = 0.0;
      for (const std::size_t h : knot.groups) sum += share_(at(b), at(h));
      if (!within(sum, branches_[b].size())) return false;
    }
    for (const std::size_t h : knot.groups) {
      double sum = 0.0;
      for (const std::size_t b : knot.branches) sum += share_(at(b), at(h));
      if (!within(sum, groups_[h].size())) return false;
    }
    return true;
  }

  /// Carries the branches of a clear knot over; false if it can be read in several ways.
  bool tie(const Knot& knot, Doubt doubt) {
    if (knot.groups.size() == 1) return meet(knot);
    if (knot.branches.size() == 1) return part(knot);
    const Branch& first = branches_[knot.branches.front()];
    const auto all = [&](auto is) {
      return std::all_of(knot.branches.begin(), knot.branches.end(), [&](std::size_t b) { return is(branches_[b]); });
    };
    // Real roots of one mode that are near each other: which is which does not matter.
    if (all([&](const Branch& each) { return each.size() == 1 && each.owners == first.owners; })) return inOrder(knot);
    // Roots that coincided: shapes choose; where they do not, the order in which the roots leave, as near as can be to
    // where they do.
    if (!all([&](const Branch& each) { return each.group == first.group; })) return false;
    return byShape(knot) || partTogether(knot) || (doubt != Doubt::kRefuse && inOrder(knot));
  }

  bool meet(const Knot& knot) {
    const std::size_t h = knot.groups.front();
    const RootGroup& group = groups_[h];
    if (knot.branches.size() == 1) {
      put(branches_[knot.branches.front()].owners, h);
      return true;
    }
    if (group.isComplex() && group.size() == 2) {  // two real roots have become a pair
      const Branch& a = branches_[knot.branches[0]];
      const Branch& b = branches_[knot.branches[1]];
      const bool ordered = a.value.real() <= b.value.real();
      put({(ordered ? a : b).owners.front(), (ordered ? b : a).owners.front()}, h);
      return true;
    }
    // Roots that coincide: each branch keeps its part of the subspace; real roots of one mode are its pair again.
    std::vector<std::size_t> ordered = knot.branches;
    std::stable_sort(ordered.begin(), ordered.end(),
                     [&](std::size_t a, std::size_t b) { return branches_[a].owners < branches_[b].owners; });
    std::vector<std::vector<int>> owners;
    Eigen::MatrixXcd parts(group.size(), group.size());
    Index column = 0;
    for (const std::size_t each : ordered) {
      const Branch& branch = branches_[each];
      parts.middleCols(column, branch.size()) = group.left * branch.right;
      column += branch.size();
      if (group.isComplex() && branch.size() == 1 && !owners.empty() && owners.back() == branch.owners) {
        owners.back().push_back(branch.owners.front());
      } else {
        owners.push_back(branch.owners);
      }
    }
    return share(h, owners, parts);
  }

  /// Gives each owner a part of a group's subspace.
  /// @param parts  in coordinates of the group's basis, side by side
  bool share(std::size_t h, const std::vector<std::vector<int>>& owners, const Eigen::MatrixXcd& parts) {
    const RootGroup& group = groups_[h];
    const Eigen::MatrixXcd right = group.right * parts;
    const Eigen::MatrixXcd left = parts.partialPivLu().solve(group.left);
    if (!left.allFinite()) return false;
    Index column = 0;
    for (const std::vector<int>& each : owners) {
      const auto size = static_cast<Index>(each.size());
      next_.push_back({each, group.value, h, right.middleCols(column, size), left.middleRows(column, size)});
      column += size;
    }
    return true;
  }

  /// Pairs that coincide have become real roots that coincide: each pair has one of its roots in either group.
  bool partTogether(const Knot& knot) {
    const auto pairs = static_cast<Index>(knot.branches.size());
    if (knot.groups.size() != 2) return false;
    for (const std::size_t h : knot.groups) {
      if (groups_[h].size() != pairs || groups_[h].isComplex()) return false;
      std::vector<std::vector<int>> owners;
      Eigen::MatrixXcd parts(pairs, pairs);
      for (Index i = 0; i < pairs; ++i) {
        const std::size_t b = knot.branches[static_cast<std::size_t>(i)];
        if (branches_[b].size() != 2 || std::abs(share_(at(b), at(h)) - 1.0) > kClear) return false;
        const Eigen::MatrixXcd part = groups_[h].left * branches_[b].right;  // of one root, so of rank one
        parts.col(i) = Eigen::JacobiSVD<Eigen::MatrixXcd>(part, Eigen::ComputeThinU).matrixU().col(0);
        owners.push_back({branches_[b].owners.front()});
      }
      if (!share(h, owners, parts)) return false;
    }
    return true;
  }

  /// A pair has become two real roots, or what is nobody's any groups.
  bool part(const Knot& knot) {
    const Branch& branch = branches_[knot.branches.front()];
    const bool nobodys =
        std::all_of(branch.owners.begin(), branch.owners.end(), [](int each) { return each == kNobody; });
    if (!nobodys && knot.groups.size() != 2) return false;
    std::vector<std::size_t> ordered = knot.groups;
    std::sort(ordered.begin(), ordered.end(),
              [&](std::size_t a, std::size_t b) { return groups_[a].value.real() < groups_[b].value.real(); });
    auto owner = branch.owners.begin();
    for (const std::size_t h : ordered) {
      put({owner, owner + groups_[h].size()}, h);
      owner += groups_[h].size();
    }
    return true;
  }

  /// Gives each group of a knot the branch that shares nearly all with it, if there is one for each.
  bool byShape(const Knot& knot) {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (const std::size_t h : knot.groups) {
      for (const std::size_t b : knot.branches) {
        const double share = share_(at(b), at(h)) / static_cast<double>(groups_[h].size());
        if (branches_[b].size() == groups_[h].size() && std::abs(share - 1.0) < kClear) pairs.emplace_back(b, h);
      }
    }
    if (pairs.size() != knot.groups.size() || pairs.size() != knot.branches.size()) return false;
    for (const auto& [b, h] : pairs) put(branches_[b].owners, h);
    return true;
  }

  /// Gives the branches to groups of their size, both in their order.
  bool inOrder(const Knot& knot) {
    std::vector<std::size_t> left = knot.branches;
    std::stable_sort(left.begin(), left.end(),
                     [&](std::size_t a, std::size_t b) { return branches_[a].owners < branches_[b].owners; });
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (const std::size_t h : knot.groups) {
      const auto next = std::find_if(left.begin(), left.end(),
                                     [&](std::size_t b) { return branches_[b].size() == groups_[h].size(); });
      if (next == left.end()) return false;
      pairs.emplace_back(*next, h);
      left.erase(next);
    }
    for (const auto& [b, h] : pairs) put(branches_[b].owners, h);
    return true;
  }

  void lose(const Knot& knot) {
    std::erase_if(next_, [&](const Branch& each) {
      return std::find(knot.groups.begin(), knot.groups.end(), each.group) != knot.groups.end();
    });
    for (const std::size_t h : knot.groups) {
      put(std::vector<int>(static_cast<std::size_t>(groups_[h].size()), kNobody), h);
    }
  }

  /// Groups that share with no branch belong to nobody.
  void loseTheRest() {
    for (std::size_t h = 0; h < groups_.size(); ++h) {
      const bool has = std::any_of(next_.begin(), next_.end(), [h](const Branch& each) { return each.group == h; });
      if (!has) put(std::vector<int>(static_cast<std::size_t>(groups_[h].size()), kNobody), h);
    }
  }

  void put(std::vector<int> owners, std::size_t h) {
    next_.push_back({std::move(owners), groups_[h].value, h, groups_[h].right, groups_[h].left});
  }

  /// Whether two branches have passed each other so closely that their coupling decides which is which.
  [[nodiscard]] bool modesMeet() const {
    struct Passage {
      std::size_t branch;
      std::size_t group;
    };
    std::vector<Passage> passages;
    for (std::size_t b = 0; b < branches_.size(); ++b) {
      const auto next = std::find_if(next_.begin(), next_.end(), [&](const Branch& each) {
        return each.owners == branches_[b].owners && relative(b, each.group) > 1.0 - kClear;
      });
      if (next != next_.end()) passages.push_back({b, next->group});
    }
    for (std::size_t i = 0; i < passages.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const auto [b, g] = passages[i];
        const auto [c, h] = passages[j];
        if (g == h || branches_[b].owners == branches_[c].owners) continue;
        const Complex before = branches_[b].value - branches_[c].value;
        const Complex after = groups_[g].value - groups_[h].value;
        const double nearest = distanceOf(before, after);
        if (nearest >= 0.5 * std::min(std::abs(before), std::abs(after))) continue;
        const double shared = std::max(relative(b, h), relative(c, g));
        const double coupling = std::sqrt(shared) / std::abs(1.0 / before - 1.0 / after);
        const double size = std::max(std::abs(groups_[g].value), std::abs(groups_[h].value));
        if (coupling > kCoupled * size && nearest < kFarApart * coupling) return true;
      }
    }
    return false;
  }

  const std::vector<Branch>& branches_;
  const std::vector<RootGroup>& groups_;
  Eigen::MatrixXd share_;  // (branches x groups)
  std::vector<Branch> next_;
};

}  // namespace

std::optional<std::vector<Branch>> advance(const std::vector<Branch>& branches, const std::vector<RootGroup>& groups,
                                           Doubt doubt) {
  return Step(branches, groups).take(doubt);
}

bool sameOwners(const std::vector<Branch>& a, const std::vector<Branch>& b) {
  const auto ownersOf = [](const std::vector<Branch>& branches) {
    std::vector<std::pair<std::size_t, std::vector<int>>> list;
    for (const Branch& each : branches) list.emplace_back(each.group, each.owners);
    std::sort(list.begin(), list.end());
    return list;
  };
  return ownersOf(a) == ownersOf(b);
}

}  // namespace vehicle
