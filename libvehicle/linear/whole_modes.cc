#include "libvehicle/linear/whole_modes.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "libvehicle/linear/undamped.h"
#include "libvehicle/system/dense_solvers.h"

namespace vehicle {

namespace {

using Eigen::Index;

bool isReal(const Mode& mode) { return mode.eigenvalue.imag() == 0.0; }

/// "carbody pitch" of "carbody pitch, aperiodic (2)".
std::string withoutKind(std::string_view name) {
  for (const std::string_view kind : {", aperiodic", ", free"}) {
    if (const std::size_t at = name.find(kind); at != std::string_view::npos) return std::string(name.substr(0, at));
  }
  return std::string(name);
}

WholeMode wholeOf(std::vector<Mode> roots) {
  WholeMode whole;
  whole.names.push_back(withoutKind(roots.front().name));
  for (const Mode& each : roots) whole.names.push_back(each.name);
  whole.roots = std::move(roots);
  return whole;
}

/// Real modes of a matrix by twos.
class Pairing {
 public:
  explicit Pairing(std::vector<Mode> real) : left_(std::move(real)) {}

  /// A double root with one shape is a whole mode by itself.
  void takeDoubles() {
    for (std::size_t i = 0; i < left_.size();) {
      const auto shapes = std::count_if(left_.begin(), left_.end(),
                                        [&](const Mode& each) { return each.eigenvalue == left_[i].eigenvalue; });
      if (left_[i].multiplicity == 2 * shapes) {
        made_.push_back(wholeOf({take(i)}));
      } else {
        ++i;
      }
    }
  }

  /// @param partner  whether two roots belong together
  template <class Partner>
  void takePairs(Partner partner) {
    for (std::size_t i = 0; i < left_.size(); ++i) {
      for (std::size_t j = i + 1; j < left_.size(); ++j) {
        if (!partner(left_[i], left_[j])) continue;
        Mode second = take(j);
        Mode first = take(i);
        made_.push_back(wholeOf({std::move(first), std::move(second)}));
        --i;
        break;
      }
    }
  }

  std::vector<WholeMode> finish() {
    while (!left_.empty()) made_.push_back(wholeOf({take(0)}));
    return std::move(made_);
  }

  [[nodiscard]] bool isDone() const { return left_.empty(); }

 private:
  Mode take(std::size_t i) {
    Mode mode = std::move(left_[i]);
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
    return mode;
  }

  std::vector<Mode> left_;
  std::vector<WholeMode> made_;
};

/// A root of a whole mode in its group, and how many of the group's roots it stands for.
struct Entry {
  int owner;
  const Mode* root;
  Index roots;
};

/// State (q, lambda q) of a root, or what a double real root spans with one shape.
Eigen::MatrixXcd spanOf(const Entry& entry, const Eigen::VectorXd& units) {
  const Index N = units.size() / 2;
  const Eigen::VectorXcd& q = entry.root->shape;
  Eigen::MatrixXcd span = Eigen::MatrixXcd::Zero(2 * N, entry.roots);
  span.col(0).head(N) = q;
  if (entry.roots == 2 && isReal(*entry.root)) {
    span.col(1).tail(N) = q;
  } else {
    span.col(0).tail(N) = entry.root->eigenvalue * q;
    if (entry.roots == 2) span.col(1) = span.col(0).conjugate();
  }
  return units.cwiseInverse().asDiagonal() * span;
}

void addBranches(const RootGroup& group, std::size_t place, const std::vector<Entry>& entries,
                 const Eigen::VectorXd& units, std::vector<Branch>& branches) {
  Index roots = 0;
  for (const Entry& each : entries) roots += each.roots;
  const bool one_owner = !entries.empty() && std::all_of(entries.begin(), entries.end(), [&](const Entry& each) {
    return each.owner == entries.front().owner;
  });
  const auto size = static_cast<std::size_t>(group.size());
  if (roots != group.size() || one_owner) {  // fewer shapes than roots: nobody's
    const int owner = roots == group.size() ? entries.front().owner : kNobody;
    branches.push_back({std::vector<int>(size, owner), group.value, place, group.right, group.left});
    return;
  }
  Eigen::MatrixXcd right(group.right.rows(), group.size());
  Index column = 0;
  for (const Entry& each : entries) {
    right.middleCols(column, each.roots) = group.right * (group.left * spanOf(each, units));
    column += each.roots;
  }
  const Eigen::MatrixXcd left = (group.left * right).partialPivLu().solve(group.left);
  column = 0;
  for (const Entry& each : entries) {
    branches.push_back({std::vector<int>(static_cast<std::size_t>(each.roots), each.owner), group.value, place,
                        right.middleCols(column, each.roots), left.middleRows(column, each.roots)});
    column += each.roots;
  }
}

}  // namespace

std::vector<WholeMode> wholeModesOf(const Eigen::MatrixXd& A, const std::vector<Channel>& states) {
  const Index N = A.rows() / 2;
  std::vector<WholeMode> whole;
  std::vector<Mode> real;
  for (Mode& each : modesOf(A, states)) {
    if (isReal(each)) {
      real.push_back(std::move(each));
    } else {
      whole.push_back(wholeOf({std::move(each)}));
    }
  }
  Pairing pairing(std::move(real));
  pairing.takeDoubles();
  if (!pairing.isDone() && !A.bottomRightCorner(N, N).isZero(0.0)) {
    const std::vector<UndampedMode> undamped = undampedModesOf(A, states);
    pairing.takePairs([&](const Mode& a, const Mode& b) {
      return std::any_of(undamped.begin(), undamped.end(), [&](const UndampedMode& each) {
        const std::vector<Mode>& roots = each.damped.roots;
        return roots.size() == 2 && ((roots[0].name == a.name && roots[1].name == b.name) ||
                                     (roots[0].name == b.name && roots[1].name == a.name));
      });
    });
  }
  pairing.takePairs([](const Mode& a, const Mode& b) { return withoutKind(a.name) == withoutKind(b.name); });
  for (WholeMode& each : pairing.finish()) whole.push_back(std::move(each));
  std::stable_sort(whole.begin(), whole.end(), [](const WholeMode& a, const WholeMode& b) {
    return std::abs(a.roots.front().eigenvalue) < std::abs(b.roots.front().eigenvalue);
  });
  return whole;
}

std::vector<Branch> firstBranches(const std::vector<WholeMode>& modes, const std::vector<RootGroup>& groups,
                                  const Eigen::VectorXd& units) {
  std::vector<std::vector<Entry>> entries(groups.size());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const std::vector<Mode>& roots = modes[m].roots;
    for (const Mode& root : roots) {
      const auto nearest = std::min_element(groups.begin(), groups.end(), [&](const RootGroup& a, const RootGroup& b) {
        return std::abs(a.value - root.eigenvalue) < std::abs(b.value - root.eigenvalue);
      });
      // A double real root alone in its mode is both of the mode's roots.
      const bool both = !isReal(root) || (roots.size() == 1 && root.multiplicity > 1);
      entries[static_cast<std::size_t>(nearest - groups.begin())].push_back({static_cast<int>(m), &root, both ? 2 : 1});
    }
  }
  std::vector<Branch> branches;
  for (std::size_t g = 0; g < groups.size(); ++g) addBranches(groups[g], g, entries[g], units, branches);
  return branches;
}

}  // namespace vehicle
