// "mbs-linear" must be the physics of the hand-written equations: what Simbody makes of bodies, joints and one force
// element is compared with equations written here, which know no Simbody.
#include <cctype>
#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/mbs/mbs_form.h"
#include "libvehicle/model/rest.h"
#include "libvehicle/model/topology.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]

std::vector<double> randomVector(std::mt19937_64& generator, std::size_t size) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<double> made(size);
  for (double& each : made) each = uniform(generator);
  return made;
}

/// A sum that also knows the size of its terms: what rounding in any order of summation is measured by.
struct Sum {
  double value = 0.0;
  double size = 0.0;
  void operator+=(double term) {
    value += term;
    size += std::abs(term);
  }
};

/// q'' of the paper's vehicle by its equations (2)-(5) in the consistent reading.
std::vector<Sum> paperAccelerations(const std::vector<double>& x, const std::vector<double>& u) {
  const double mk = 57e3, jk = 70e3, mb = 9e3, ak = 3.725, cb = 3040e3, bb = 30e3, ck = 2660e3, bk = 100e3;
  const double zk = x[0], phi = x[1], z1 = x[2], z2 = x[3], vk = x[4], w = x[5], v1 = x[6], v2 = x[7];
  std::vector<Sum> a(4);
  for (const double term : {-bk * (2 * vk), bk * v1, bk * v2, -ck * (2 * zk), ck * z1, ck * z2}) a[0] += term / mk;
  for (const double term : {-bk * 2 * ak * w, bk * v1, -bk * v2, -ck * 2 * ak * phi, ck * z1, -ck * z2}) {
    a[1] += ak * term / jk;
  }
  const double z[] = {z1, z2}, v[] = {v1, v2}, side[] = {1.0, -1.0};
  for (std::size_t i = 0; i < 2; ++i) {
    for (const double term : {bk * vk, -bk * v[i], side[i] * bk * ak * w, ck * zk, -ck * z[i], side[i] * ck * ak * phi,
                              -2 * bb * v[i], -2 * cb * z[i], bb * u[4 + 2 * i], bb * u[5 + 2 * i], cb * u[2 * i],
                              cb * u[2 * i + 1]}) {
      a[2 + i] += term / mb;
    }
  }
  return a;
}

TEST(MbsLinear, RightHandSideIsThatOfThePapersEquationsAtRandomStates) {
  const auto form = buildMbsForm(compile(paperVehicle(), kGravity), MbsLaw::kLinear);
  std::mt19937_64 generator(20170704);
  std::vector<double> dx(8);
  for (int draw = 0; draw < 1000; ++draw) {
    const std::vector<double> x = randomVector(generator, 8), u = randomVector(generator, 8);
    form->derivative(x, u, dx);
    const std::vector<Sum> expected = paperAccelerations(x, u);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(dx[i], x[4 + i]);
      // Rounding of about 20 operations and of Simbody's inversion, 45 x 2^-53 of the largest sum; a wrong term
      // shows at 1e-2.
      ASSERT_WITHIN(dx[4 + i], expected[i].value, 5e-15 * expected[i].size) << "row " << i << ", draw " << draw;
    }
  }
}

/// q'' by the assembly rule of any linear form: per spring and damper with row r, -(k r.q + c r.v) r.
class Rule {
 public:
  Rule(const Topology& topology, const Rest& rest) : topology_(topology), rest_(rest) {}

  std::vector<Sum> accelerations(const std::vector<double>& x, const std::vector<double>& u) const {
    const std::size_t n = static_cast<std::size_t>(topology_.coordinates);
    std::vector<Sum> sums(n);
    std::vector<double> inertia(n, 0.0);
    for (std::size_t i = 0; i < topology_.bodies.size(); ++i) {
      const TopologyBody& body = topology_.bodies[i];
      if (body.z_index >= 0) inertia[index(body.z_index)] = body.mass;
      if (body.pitch_index < 0) continue;
      inertia[index(body.pitch_index)] = body.pitch_inertia;
      sums[index(body.pitch_index)] += -rest_.pitch_stiffness[i] * x[index(body.pitch_index)];
    }
    for (const TopologySuspension& each : topology_.suspensions) {
      Row row(*this, x, u);
      row.add(topology_.bodies[index(each.upper)], each.arm_upper, 1.0);
      if (each.lower_body >= 0) row.add(topology_.bodies[index(each.lower_body)], each.arm_lower, -1.0);
      if (each.lower_wheelset >= 0) row.add(each.lower_wheelset, -1.0);
      row.pull(each.stiffness, each.damping, sums);
    }
    for (std::size_t j = 0; j < topology_.wheelsets.size(); ++j) {
      const TopologyWheelset& wheelset = topology_.wheelsets[j];
      if (wheelset.z_index < 0) continue;
      inertia[index(wheelset.z_index)] = wheelset.mass;
      Row row(*this, x, u);
      row.add(static_cast<int>(j), 1.0);
      row.addRail(j, -1.0);
      row.pull(rest_.contact_stiffness[j], wheelset.contact_damping, sums);
    }
    for (std::size_t i = 0; i < n; ++i) {
      sums[i].value /= inertia[i];
      sums[i].size /= inertia[i];
    }
    return sums;
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  /// One row vector, filled from both ends.
  class Row {
   public:
    Row(const Rule& rule, const std::vector<double>& x, const std::vector<double>& u) : rule_(rule), x_(x), u_(u) {}
    void add(const TopologyBody& body, double arm, double sign) {
      if (body.z_index >= 0) entry(body.z_index, sign);
      if (body.pitch_index >= 0) entry(body.pitch_index, sign * arm);
    }
    void add(int wheelset, double sign) {
      const int z = rule_.topology_.wheelsets[index(wheelset)].z_index;
      z >= 0 ? entry(z, sign) : addRail(index(wheelset), sign);
    }
    void addRail(std::size_t channel, double sign) {
      height_ += sign * u_[channel];
      rate_ += sign * u_[channel + rule_.topology_.wheelsets.size()];
    }
    void pull(double stiffness, double damping, std::vector<Sum>& sums) const {
      const double force = stiffness * height_.value + damping * rate_.value;
      const double size = stiffness * height_.size + damping * rate_.size;
      for (const auto& [coordinate, factor] : entries_) {
        sums[coordinate].value -= factor * force;
        sums[coordinate].size += std::abs(factor) * size;
      }
    }

   private:
    void entry(int coordinate, double factor) {
      entries_.emplace_back(index(coordinate), factor);
      height_ += factor * x_[index(coordinate)];
      rate_ += factor * x_[index(coordinate + rule_.topology_.coordinates)];
    }
    const Rule& rule_;
    const std::vector<double>& x_;
    const std::vector<double>& u_;
    std::vector<std::pair<std::size_t, double>> entries_;
    Sum height_, rate_;
  };

  const Topology& topology_;
  const Rest& rest_;
};

/// A vehicle as gtest prints it: by name instead of by bytes.
struct Named {
  Vehicle vehicle;
  friend void PrintTo(const Named& named_vehicle, std::ostream* out) { *out << named_vehicle.vehicle.name; }
};

class MbsLinearTopology : public ::testing::TestWithParam<Named> {};

TEST_P(MbsLinearTopology, RightHandSideFollowsTheAssemblyRule) {
  const auto form = buildMbsForm(compile(GetParam().vehicle, kGravity), MbsLaw::kLinear);
  const Topology topology = topologyOf(GetParam().vehicle);
  const Rest rest = restOf(topology, kGravity);
  const Rule rule(topology, rest);
  const std::size_t n = static_cast<std::size_t>(topology.coordinates), w = topology.wheelsets.size();
  std::mt19937_64 generator(7);
  std::vector<double> dx(2 * n);
  for (int draw = 0; draw < 200; ++draw) {
    const std::vector<double> x = randomVector(generator, 2 * n), u = randomVector(generator, 2 * w);
    form->derivative(x, u, dx);
    const std::vector<Sum> expected = rule.accelerations(x, u);
    for (std::size_t i = 0; i < n; ++i) {
      // Rounding, as in the paper's equations above.
      ASSERT_WITHIN(dx[n + i], expected[i].value, 5e-15 * expected[i].size) << "row " << i << ", draw " << draw;
    }
  }
}

TEST_P(MbsLinearTopology, MatricesReproduceTheRightHandSide) {
  const auto form = buildMbsForm(compile(GetParam().vehicle, kGravity), MbsLaw::kLinear);
  const std::optional<StateSpace> matrices = form->linear();
  ASSERT_TRUE(matrices.has_value());
  const Eigen::Index n = form->size(), w = form->channels();
  ASSERT_EQ(matrices->A.rows(), n);
  ASSERT_EQ(matrices->A.cols(), n);
  ASSERT_EQ(matrices->B.rows(), n);
  ASSERT_EQ(matrices->B.cols(), 2 * w);
  std::mt19937_64 generator(11);
  const std::vector<double> x = randomVector(generator, static_cast<std::size_t>(n));
  const std::vector<double> u = randomVector(generator, static_cast<std::size_t>(2 * w));
  std::vector<double> dx(static_cast<std::size_t>(n));
  form->derivative(x, u, dx);
  const Eigen::Map<const Eigen::VectorXd> xv(x.data(), n), uv(u.data(), 2 * w);
  const Eigen::VectorXd expected = matrices->A * xv + matrices->B * uv;
  const Eigen::VectorXd size = matrices->A.cwiseAbs() * xv.cwiseAbs() + matrices->B.cwiseAbs() * uv.cwiseAbs();
  for (Eigen::Index i = 0; i < n; ++i) {
    // Two roundings a term, up to 36 terms.
    EXPECT_WITHIN(dx[static_cast<std::size_t>(i)], expected[i], 5e-15 * size[i]) << "row " << i;
  }
}

/// Everything that a topology can have at once: pitching and plain bogies, a body that only pitches, contacts.
Vehicle mixedVehicle() {
  Vehicle made = asymmetricBogiePitchVehicle();
  made.name = "mixed";
  named(made.bodies, "rear_bogie").motion = {Motion::kPitch};
  Wheelset& moving = named(made.wheelsets, "wheelset_2");
  moving.mass = 1500.0;
  moving.contact_stiffness = 1.1e9;
  moving.contact_damping = 9e3;
  // A bogie that cannot sink hands its wheelsets only what balances its pitch: their loads are said instead.
  for (Wheelset& each : made.wheelsets) each.load = 150e3;
  return made;
}

INSTANTIATE_TEST_SUITE_P(Vehicles, MbsLinearTopology,
                         ::testing::Values(Named{paperVehicle()}, Named{asymmetricVehicle()},
                                           Named{asymmetricBogiePitchVehicle()}, Named{bogiePitchVehicle()},
                                           Named{contactVehicle()}, Named{heightsVehicle()},
                                           Named{bogiePitchHeightsVehicle()}, Named{mixedVehicle()}),
                         [](const auto& instance) {
                           std::string name;
                           for (const char c : instance.param.vehicle.name) {
                             if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
                           }
                           return name;
                         });

}  // namespace
}  // namespace vehicle::test
