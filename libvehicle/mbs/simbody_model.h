#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "libvehicle/law/suspension_law.h"

// The seam between this library (C++20) and Simbody, whose headers are C++17 at most: plain std types only, and
// of other rooms the laws alone, which are C++17 too, because simbody_model.cc must compile as C++17.
namespace vehicle {

/// A rigid body that moves in the vertical plane, in z, pitch, both or neither.
struct SimbodyBody {
  double mass = 0.0;             // [kg]      > 0 where it moves in z
  double pitch_inertia = 0.0;    // [kg m^2]  > 0 where it pitches
  double x = 0.0;                // [m] of the centre of gravity at rest
  double z = 0.0;                // [m] above rail top at rest
  int z_index = -1;              // in q; -1: does not move so
  int pitch_index = -1;          // in q
  double pitch_stiffness = 0.0;  // [N m/rad] of static loads; read by kLinear only, in kTrue it comes by itself
};

/// One end of a link: a place on a body, or the rail under a wheelset.
struct SimbodyEnd {
  int body = -1;        // exactly one of body and channel is >= 0
  int channel = -1;     // of the input: the end is at height eta and moves with eta'
  double arm = 0.0;     // [m] forward of the body's centre of gravity
  double height = 0.0;  // [m] above the body's centre of gravity
};

/// A vertical force element: a suspension or a wheel-rail contact.
/// Tension [N]:  -preload + f(d, d')  with d [m] the elongation from rest; it pulls the two ends together.
struct SimbodyLink {
  SuspensionLawPtr law;    // f
  double preload = 0.0;    // [N] compression at rest; kLinear leaves it out, as gravity
  SimbodyEnd upper;
  SimbodyEnd lower;
};

/// How elongations and forces follow from the motion of the bodies.
enum class SimbodyGeometry {
  kLinear,  // d from generalised coordinates, z + arm pitch; forces go straight to the generalised coordinates
  kTrue,    // d between the attachment points of rotated bodies; forces act at these points; gravity and preload
};

struct SimbodyAssembly {
  std::vector<SimbodyBody> bodies;
  std::vector<SimbodyLink> links;
  int coordinates = 0;   // N, size of q
  int channels = 0;      // w, size of eta
  double gravity = 0.0;  // [m/s^2] used by kTrue
  SimbodyGeometry geometry = SimbodyGeometry::kLinear;
};

/// Vertical motion of a point, measured from rest.
struct SimbodyMotion {
  double z = 0.0;   // [m]
  double vz = 0.0;  // [m/s]
  double az = 0.0;  // [m/s^2]
};

/// What Simbody's integrator has done since startRun().
struct SimbodyCost {
  long steps = 0;
  long evaluations = 0;  // of the accelerations
  long rejected = 0;     // error test or convergence failed
};

/// A Simbody System and its State. State vectors are x = (q, v), shape (2 N), inputs u = (eta, eta'), shape (2 w).
/// One object serves one thread: a Simbody System must not be shared, not even with separate States.
/// Whatever Simbody throws is a std::exception.
class SimbodyModel {
 public:
  using InputAt = std::function<void(double t, double* u)>;

  explicit SimbodyModel(const SimbodyAssembly& assembly);
  ~SimbodyModel();
  SimbodyModel(const SimbodyModel&) = delete;
  SimbodyModel& operator=(const SimbodyModel&) = delete;

  /// a = q'' at x under u, one realisation to Stage::Acceleration.  @param a  shape (N)
  void accelerations(const double* x, const double* u, double* a);

  // As they were at the last accelerations():
  [[nodiscard]] double deflection(int link) const;  // [m] elongation-positive, from rest
  [[nodiscard]] double force(int link) const;       // [N] elongation-positive, without the preload
  [[nodiscard]] SimbodyMotion motion(int body, double arm) const;  // of a point at the height of the centre of gravity

  /// Readies Simbody's Runge-Kutta-Merson at (t, x). Steps are never longer than max_step [s] and end exactly where
  /// advanceTo() says. accelerations() may be called in between.
  void startRun(double accuracy, double max_step, double t, const double* x, InputAt input_at);
  void advanceTo(double t);
  /// Says that the input's formula has changed at the time reached: what was evaluated there is forgotten.
  void passBreakpoint();
  void readState(double* x) const;    // shape (2 N)
  [[nodiscard]] SimbodyCost cost() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace vehicle
