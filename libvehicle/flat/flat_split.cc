#include "libvehicle/flat/flat_split.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace vehicle {
namespace {

// inertia y'' of a printed variant would not be that of (3.4)-(3.7).
const FlatForm& splittable(const FlatForm& form) {
  if (const std::string unsupported = splitUnsupported(form); !unsupported.empty())
    throw std::invalid_argument(unsupported);
  return form;
}

}  // namespace

void FlatHalf::output(std::span<const double> x, std::span<const double>, std::span<double> y) const {
  std::copy(x.begin(), x.end(), y.begin());
}

std::optional<StateSpace> FlatHalf::linear() const {
  // No constant term: the answer to a unit vector is a column of the matrices, exactly.
  StateSpace matrices{Eigen::MatrixXd(FlatHalfRhs::kStates, FlatHalfRhs::kStates),
                      Eigen::MatrixXd(FlatHalfRhs::kStates, FlatHalfRhs::kInputs)};
  const std::array<double, 4> zero{};
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<double, 4> unit{};
    unit[i] = 1.0;
    const auto column = static_cast<Eigen::Index>(i);
    rhs_(unit.data(), zero.data(), matrices.A.col(column).data());
    if (i < 2) rhs_(zero.data(), unit.data(), matrices.B.col(column).data());
  }
  return matrices;
}

std::string splitUnsupported(const FlatForm& form) {
  if (form.rhs() == nullptr) return "bounce and pitch are independent in the form flat only; this is a printed variant";
  const FlatParameters& v = form.parameters();
  std::string pairs;
  const auto compare = [&](const std::string& one, double a, const std::string& other, double b, const char* unit) {
    if (a == b) return;
    pairs += fmt::format("{}{} = {:.17g} {}, {} = {:.17g} {}", pairs.empty() ? "" : "; ", one, a, unit, other, b, unit);
  };
  compare("mass of the front bogie", v.m1, "of the rear one", v.m2, "kg");
  compare("arm of the front secondary", v.lf, "of the rear one", v.lr, "m");
  compare("stiffness of the front secondary", v.cs1, "of the rear one", v.cs2, "N/m");
  compare("damping of the front secondary", v.bs1, "of the rear one", v.bs2, "N*s/m");
  for (std::size_t wheel = 1; wheel < 4; ++wheel) {
    const std::string of = fmt::format("of wheel {}", wheel + 1);
    compare("primary stiffness of wheel 1", v.cp[0], of, v.cp[wheel], "N/m");
    compare("primary damping of wheel 1", v.bp[0], of, v.bp[wheel], "N*s/m");
  }
  if (pairs.empty()) return {};
  return "bounce and pitch are independent only where front and rear of a vehicle are equal, and here they differ: " +
         pairs;
}

FlatSplit::FlatSplit(const FlatForm& form)
    : bounce_({splittable(form).parameters(), form.parameters().mk, 1.0, 0.0},
              {{"carbody.z", "m"}, {"bogies.mean_z", "m"}, {"carbody.vz", "m/s"}, {"bogies.mean_vz", "m/s"}}),
      pitch_({form.parameters(), form.parameters().Jk, form.parameters().lf, form.parameters().k_g},
             {{"carbody.pitch", "rad"}, {"bogies.half_difference_z", "m"},
              {"carbody.pitch_rate", "rad/s"}, {"bogies.half_difference_vz", "m/s"}}) {
  for (std::size_t wheel = 0; wheel < 4; ++wheel) {
    const auto channel = static_cast<std::size_t>(form.wheelOrder()[wheel]);
    mixing_[channel] = 0.25;
    mixing_[4 + channel] = wheel < 2 ? 0.25 : -0.25;
  }
  std::transform(form.stateOrder().begin(), form.stateOrder().end(), place_.begin(),
                 [](int index) { return static_cast<std::size_t>(index); });
}

void FlatSplit::toHalves(std::span<const double> x, std::span<double> halves) const {
  for (std::size_t rate = 0; rate < 2; ++rate) {  // displacements, then velocities
    const double front = x[place_[4 * rate + 2]];
    const double rear = x[place_[4 * rate + 3]];
    double* of_bounce = halves.data() + 2 * rate;
    double* of_pitch = of_bounce + 4;
    of_bounce[0] = x[place_[4 * rate]];
    of_bounce[1] = 0.5 * (front + rear);
    of_pitch[0] = x[place_[4 * rate + 1]];
    of_pitch[1] = 0.5 * (front - rear);
  }
}

void FlatSplit::fromHalves(std::span<const double> halves, std::span<double> x) const {
  for (std::size_t rate = 0; rate < 2; ++rate) {
    const double* of_bounce = halves.data() + 2 * rate;
    const double* of_pitch = of_bounce + 4;
    x[place_[4 * rate]] = of_bounce[0];
    x[place_[4 * rate + 1]] = of_pitch[0];
    x[place_[4 * rate + 2]] = of_bounce[1] + of_pitch[1];
    x[place_[4 * rate + 3]] = of_bounce[1] - of_pitch[1];
  }
}

}  // namespace vehicle
