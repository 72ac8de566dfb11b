#include "libvehicle/law/linear_spring_damper.h"

namespace vehicle {

double LinearSpringDamper::force(const LawPoint& at) const { return stiffness_ * at.elongation + damping_ * at.rate; }

LawSlopes LinearSpringDamper::slopes(const LawPoint& /*at*/) const { return {stiffness_, damping_, {}, {}}; }

double LinearSpringDamper::storedEnergy(const LawPoint& at) const {
  return 0.5 * stiffness_ * at.elongation * at.elongation;
}

double LinearSpringDamper::dissipatedPower(const LawPoint& at) const { return damping_ * at.rate * at.rate; }

}  // namespace vehicle
