// The only file of the library that is C++17 (Simbody's headers do not compile as C++20) and the only one that
// insists on asserts: the packaged library lays its State out without NDEBUG, and a caller with it segfaults.
#ifdef NDEBUG
#error "simbody_model.cc must be compiled without NDEBUG: the layout of Simbody's State depends on it"
#endif
#if __cplusplus != 201703L
#error "simbody_model.cc must be compiled as C++17: Simbody's headers do not compile as C++20"
#endif

#include "libvehicle/mbs/simbody_model.h"

#include <utility>

#include <Simbody.h>

namespace vehicle {
namespace {

// Simbody's Ground is the vehicle's frame: x forward, y left, z up. Its joints slide along their own x and turn
// about their own z. The joint frames below are exchanges of axes, so they hold zeros and ones only and a
// turned axis costs no rounding (a rotation by pi/2 would: cos(pi/2) = 6e-17).
SimTK::Rotation axes(const SimTK::Vec3& x, const SimTK::Vec3& y, const SimTK::Vec3& z) {
  return SimTK::Rotation(SimTK::Mat33(x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]), true);
}
const SimTK::Vec3 kForward(1, 0, 0), kLeft(0, 1, 0), kRight(0, -1, 0), kUp(0, 0, 1);

/// A body in Simbody and where its coordinates stand in Simbody's q and u; -1: none.
struct PlacedBody {
  SimTK::MobilizedBody body;
  SimbodyBody given;
  int z_slot = -1;
  int pitch_slot = -1;
};

/// Elongation of a link from rest, its rate and its force.
struct LinkState {
  double deflection = 0.0;  // d  [m]
  double rate = 0.0;        // d' [m/s]
  double force = 0.0;       // k d + c d' [N]
};

struct EndState {
  double z = 0.0;   // [m] from rest
  double vz = 0.0;  // [m/s]
};

/// What force element and model share: the input of the moment, and the forces of the last evaluation.
struct Exchange {
  std::vector<double> u;  // (eta, eta'), shape (2 w)
  const SimbodyModel::InputAt* input_at = nullptr;  // given: u is asked for at the State's time
  std::vector<LinkState> links;
  long evaluations = 0;
};

/// All suspensions and contacts in one force element: per link one elongation, one law, two ends.
///
/// A wheelset that follows the rail is no body here: its height and rate enter the forces above it. Prescribing a
/// body's motion instead would give the same accelerations and would ask for eta'' too, which the forces do not need.
class Links : public SimTK::Force::Custom::Implementation {
 public:
  Links(const SimbodyAssembly& assembly, const std::vector<PlacedBody>& bodies, Exchange& exchange)
      : assembly_(assembly), bodies_(bodies), exchange_(exchange) {}

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& /*particle_forces*/, SimTK::Vector& mobility_forces) const override {
    if (exchange_.input_at != nullptr) {
      (*exchange_.input_at)(state.getTime(), exchange_.u.data());
      ++exchange_.evaluations;
    }
    const bool linear = assembly_.geometry == SimbodyGeometry::kLinear;
    for (std::size_t i = 0; i < assembly_.links.size(); ++i) {
      const SimbodyLink& link = assembly_.links[i];
      LinkState& now = exchange_.links[i];
      now = linkState(state, link);
      const double pull = linear ? now.force : now.force - link.preload;
      if (linear) {
        applyToCoordinates(link.upper, -pull, mobility_forces);
        applyToCoordinates(link.lower, pull, mobility_forces);
      } else {
        applyAtPoint(state, link.upper, -pull, body_forces);
        applyAtPoint(state, link.lower, pull, body_forces);
      }
    }
    if (!linear) return;
    for (const PlacedBody& placed : bodies_) {
      if (placed.pitch_slot < 0) continue;
      mobility_forces[placed.pitch_slot] -= placed.given.pitch_stiffness * state.getQ()[placed.pitch_slot];
    }
  }

  /// [J] of the springs, preload included where it acts; gravity counts its own. The rail may do work on it.
  SimTK::Real calcPotentialEnergy(const SimTK::State& state) const override {
    const bool linear = assembly_.geometry == SimbodyGeometry::kLinear;
    double energy = 0.0;
    for (const SimbodyLink& link : assembly_.links) {
      LawPoint at;
      at.elongation = linkState(state, link).deflection;
      energy += link.law->storedEnergy(at) - (linear ? 0.0 : link.preload * at.elongation);
    }
    for (const PlacedBody& placed : bodies_) {
      if (!linear || placed.pitch_slot < 0) continue;
      const double pitch = state.getQ()[placed.pitch_slot];
      energy += 0.5 * placed.given.pitch_stiffness * pitch * pitch;
    }
    return energy;
  }

  // Dampers and the rail: true here would freeze both between two changes of position.
  bool dependsOnlyOnPositions() const override { return false; }

 private:
  const PlacedBody& placed(const SimbodyEnd& end) const { return bodies_[static_cast<std::size_t>(end.body)]; }
  static SimTK::Vec3 station(const SimbodyEnd& end) { return SimTK::Vec3(end.arm, 0, end.height); }

  EndState endState(const SimTK::State& state, const SimbodyEnd& end) const {
    if (end.channel >= 0) {
      const auto channel = static_cast<std::size_t>(end.channel);
      return {exchange_.u[channel], exchange_.u[channel + static_cast<std::size_t>(assembly_.channels)]};
    }
    const PlacedBody& on = placed(end);
    if (assembly_.geometry == SimbodyGeometry::kTrue) {
      SimTK::Vec3 location, velocity;
      on.body.findStationLocationAndVelocityInGround(state, station(end), location, velocity);
      return {location[2] - (on.given.z + end.height), velocity[2]};
    }
    EndState at;
    if (on.z_slot >= 0) at = {state.getQ()[on.z_slot], state.getU()[on.z_slot]};
    if (on.pitch_slot >= 0) {
      at.z += end.arm * state.getQ()[on.pitch_slot];
      at.vz += end.arm * state.getU()[on.pitch_slot];
    }
    return at;
  }

  LinkState linkState(const SimTK::State& state, const SimbodyLink& link) const {
    const EndState upper = endState(state, link.upper), lower = endState(state, link.lower);
    LinkState now;
    now.deflection = upper.z - lower.z;
    now.rate = upper.vz - lower.vz;
    LawPoint at;
    at.elongation = now.deflection;
    at.rate = now.rate;
    now.force = link.law->force(at);
    return now;
  }

  void applyToCoordinates(const SimbodyEnd& end, double up, SimTK::Vector& mobility_forces) const {
    if (end.channel >= 0) return;  // the rail takes it
    const PlacedBody& on = placed(end);
    if (on.z_slot >= 0) mobility_forces[on.z_slot] += up;
    if (on.pitch_slot >= 0) mobility_forces[on.pitch_slot] += end.arm * up;
  }

  void applyAtPoint(const SimTK::State& state, const SimbodyEnd& end, double up,
                    SimTK::Vector_<SimTK::SpatialVec>& body_forces) const {
    if (end.channel >= 0) return;
    placed(end).body.applyForceToBodyPoint(state, station(end), up * kUp, body_forces);
  }

  const SimbodyAssembly& assembly_;
  const std::vector<PlacedBody>& bodies_;
  Exchange& exchange_;
};

}  // namespace

/// Order of members: what is referred to comes before what refers to it.
struct SimbodyModel::Parts {
  explicit Parts(const SimbodyAssembly& given)
      : assembly(given), matter(system), forces(system) {
    exchange.u.assign(2 * static_cast<std::size_t>(given.channels), 0.0);
    exchange.links.resize(given.links.size());
    for (const SimbodyBody& body : given.bodies) place(body);
    SimTK::Force::Custom(forces, new Links(assembly, bodies, exchange));  // the subsystem owns it
    if (given.geometry == SimbodyGeometry::kTrue) {
      SimTK::Force::UniformGravity(forces, matter, SimTK::Vec3(0, 0, -given.gravity));
    }
    state = system.realizeTopology();
    system.realizeModel(state);
    slot_of_coordinate.assign(static_cast<std::size_t>(given.coordinates), -1);
    for (PlacedBody& placed : bodies) findSlots(placed);
  }

  void place(const SimbodyBody& given) {
    PlacedBody placed;
    placed.given = given;
    const SimTK::Transform here(SimTK::Vec3(given.x, 0, given.z));
    const SimTK::Rotation slides_up = axes(kUp, kForward, kLeft);
    // Pitch is positive nose-up: about the axis to the right.
    const SimTK::Rotation turns_nose_up = axes(kForward, kUp, kRight);
    // Roll and yaw never move, so their inertias are free; three equal ones are always a possible body.
    const double inertia = given.pitch_index >= 0 ? given.pitch_inertia : 0.0;
    const SimTK::Body::Rigid mass(
        SimTK::MassProperties(given.mass, SimTK::Vec3(0), SimTK::Inertia(inertia, inertia, inertia)));
    const SimTK::Body::Rigid no_mass(SimTK::MassProperties(0, SimTK::Vec3(0), SimTK::Inertia(0)));
    const bool slides = given.z_index >= 0, turns = given.pitch_index >= 0;
    if (slides && turns) {
      // A slider without mass carries the pin: z and pitch stay coordinates of their own, in any attitude.
      SimTK::MobilizedBody::Slider slider(matter.Ground(), SimTK::Transform(slides_up, here.p()), no_mass,
                                          SimTK::Transform(slides_up));
      placed.body = SimTK::MobilizedBody::Pin(slider, SimTK::Transform(turns_nose_up), mass,
                                              SimTK::Transform(turns_nose_up));
    } else if (slides) {
      placed.body = SimTK::MobilizedBody::Slider(matter.Ground(), SimTK::Transform(slides_up, here.p()), mass,
                                                 SimTK::Transform(slides_up));
    } else if (turns) {
      placed.body = SimTK::MobilizedBody::Pin(matter.Ground(), SimTK::Transform(turns_nose_up, here.p()), mass,
                                              SimTK::Transform(turns_nose_up));
    } else {
      placed.body = SimTK::MobilizedBody::Weld(matter.Ground(), here, mass, SimTK::Transform());
    }
    bodies.push_back(placed);
  }

  // Sliders and pins have one q and one u each, and u = q': one slot serves both.
  void findSlots(PlacedBody& placed) {
    const bool slides = placed.given.z_index >= 0, turns = placed.given.pitch_index >= 0;
    if (turns) {
      placed.pitch_slot = placed.body.getFirstQIndex(state);
      slot_of_coordinate[static_cast<std::size_t>(placed.given.pitch_index)] = placed.pitch_slot;
    }
    if (slides) {
      const SimTK::MobilizedBody& slider = turns ? placed.body.getParentMobilizedBody() : placed.body;
      placed.z_slot = slider.getFirstQIndex(state);
      slot_of_coordinate[static_cast<std::size_t>(placed.given.z_index)] = placed.z_slot;
    }
  }

  void write(const double* x, SimTK::State& to) const {
    SimTK::Vector& q = to.updQ();
    SimTK::Vector& v = to.updU();
    const std::size_t n = slot_of_coordinate.size();
    for (std::size_t i = 0; i < n; ++i) {
      q[slot_of_coordinate[i]] = x[i];
      v[slot_of_coordinate[i]] = x[n + i];
    }
  }

  SimbodyAssembly assembly;
  std::vector<PlacedBody> bodies;
  Exchange exchange;
  std::vector<int> slot_of_coordinate;  // of q_i in Simbody's q, and of q_i' in its u
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter;
  SimTK::GeneralForceSubsystem forces;
  SimTK::State state;  // of accelerations()
  InputAt input_at;    // of the run
  std::unique_ptr<SimTK::RungeKuttaMersonIntegrator> integrator;
};

SimbodyModel::SimbodyModel(const SimbodyAssembly& assembly) : parts_(new Parts(assembly)) {}
SimbodyModel::~SimbodyModel() = default;

void SimbodyModel::accelerations(const double* x, const double* u, double* a) {
  Parts& m = *parts_;
  m.exchange.input_at = nullptr;
  m.exchange.u.assign(u, u + m.exchange.u.size());
  m.write(x, m.state);
  m.system.realize(m.state, SimTK::Stage::Acceleration);
  const SimTK::Vector& rate = m.state.getUDot();
  for (std::size_t i = 0; i < m.slot_of_coordinate.size(); ++i) a[i] = rate[m.slot_of_coordinate[i]];
}

double SimbodyModel::deflection(int link) const {
  return parts_->exchange.links[static_cast<std::size_t>(link)].deflection;
}

double SimbodyModel::force(int link) const { return parts_->exchange.links[static_cast<std::size_t>(link)].force; }

SimbodyMotion SimbodyModel::motion(int body, double arm) const {
  const PlacedBody& placed = parts_->bodies[static_cast<std::size_t>(body)];
  const SimTK::State& state = parts_->state;
  if (parts_->assembly.geometry == SimbodyGeometry::kTrue) {
    SimTK::Vec3 p, v, a;
    placed.body.findStationLocationVelocityAndAccelerationInGround(state, SimTK::Vec3(arm, 0, 0), p, v, a);
    return {p[2] - placed.given.z, v[2], a[2]};
  }
  SimbodyMotion at;
  if (placed.z_slot >= 0) {
    at = {state.getQ()[placed.z_slot], state.getU()[placed.z_slot], state.getUDot()[placed.z_slot]};
  }
  if (placed.pitch_slot >= 0) {
    at.z += arm * state.getQ()[placed.pitch_slot];
    at.vz += arm * state.getU()[placed.pitch_slot];
    at.az += arm * state.getUDot()[placed.pitch_slot];
  }
  return at;
}

void SimbodyModel::startRun(double accuracy, double max_step, double t, const double* x, InputAt input_at) {
  Parts& m = *parts_;
  m.input_at = std::move(input_at);
  m.exchange.input_at = &m.input_at;
  m.exchange.evaluations = 0;
  // Settings changed after initialize() are ignored, hence a fresh integrator for every run. Without
  // interpolation a step is cut where advanceTo() says; with it the state there would be a cubic through two steps.
  m.integrator.reset(new SimTK::RungeKuttaMersonIntegrator(m.system));
  m.integrator->setAccuracy(accuracy);
  m.integrator->setMaximumStepSize(max_step);
  m.integrator->setAllowInterpolation(false);
  SimTK::State start = m.state;
  start.setTime(t);
  m.write(x, start);
  m.integrator->initialize(start);
}

void SimbodyModel::advanceTo(double t) {
  parts_->exchange.input_at = &parts_->input_at;
  // stepTo() also returns for reasons of its own, such as the start of a continuous interval.
  while (parts_->integrator->getTime() < t) parts_->integrator->stepTo(t);
}

void SimbodyModel::passBreakpoint() {
  SimTK::Integrator& integrator = *parts_->integrator;
  // Simbody 3.7 evaluates the first stage when a step begins, so it holds nothing stale here; that is its habit, not
  // its promise.
  integrator.updAdvancedState().invalidateAllCacheAtOrAbove(SimTK::Stage::Time);
  // A Runge-Kutta step carries nothing over but its size, which this keeps: the vehicle's pace is the same.
  integrator.reinitialize(SimTK::Stage::Time, false);
}

void SimbodyModel::readState(double* x) const {
  const SimTK::State& state = parts_->integrator->getState();
  const std::size_t n = parts_->slot_of_coordinate.size();
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = state.getQ()[parts_->slot_of_coordinate[i]];
    x[n + i] = state.getU()[parts_->slot_of_coordinate[i]];
  }
}

SimbodyCost SimbodyModel::cost() const {
  const SimTK::Integrator& integrator = *parts_->integrator;
  return {integrator.getNumStepsTaken(), parts_->exchange.evaluations,
          integrator.getNumErrorTestFailures() + integrator.getNumConvergenceTestFailures()};
}

}  // namespace vehicle
