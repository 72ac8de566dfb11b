#pragma once

// Equations (2)-(5) of the source paper in their consistent reading, one function an equation; as they are generalised
// here they are (3.1)-(3.3) of docs/theory/vertical.md, and the couplings of a train are its (8.1)-(8.3).
//
// 1. T is a number: `double` in the flat form, a SIMD pack with one design per lane in an ensemble. So there is
//    no std, no Eigen and no branch here, and everything is forced inline: the kernel files of an ensemble are
//    compiled for other instruction sets, and an out-of-line copy of theirs must never serve baseline code.
// 2. Masses come inverted: a division costs as much as a dozen products and serves no purpose here.
// 3. The rail comes as an argument. It costs several times what the equations do, so its owner is the caller.
// 4. Terms that equations share (a secondary's damper and spring) are written out in each of them, in the same
//    order: the reader sees the printed equation, the compiler computes the common term once.
//
// The paper's vehicle is symmetric; here front and rear may differ in everything. Its ak becomes lf and lr, its
// 2 bb the sum of a bogie's two axles, and in (2) the phi terms no longer cancel.

namespace vehicle {

/// Coefficients of the equations, in the paper's letters: k carbody, b bogie; c stiffness, b damping.
template <class T>
struct FlatCoefficients {
  T inv_mk, inv_Jk, inv_m1, inv_m2;  // [1/kg, 1/(kg m^2)] carbody, carbody pitch, front bogie, rear bogie
  T lf, lr;                          // [m] secondary ahead of / behind the carbody's CG (the paper's ak)
  T ck1, bk1, ck2, bk2;              // [N/m, N s/m] secondary, front and rear (the paper's ck, bk)
  T cb1, bb1, cb2, bb2;              // [N/m, N s/m] primary of the wheels 1, 2 under the front bogie
  T cb3, bb3, cb4, bb4;              // [N/m, N s/m] primary of the wheels 3, 4 under the rear bogie
  T cb12, bb12, cb34, bb34;          // sums over a bogie's two axles (the paper's 2 cb, 2 bb)
  T kg;                              // [N m/rad] pitch stiffness from static loads at heights; 0 without heights
};

/// Displacements [m, rad] and velocities from the loaded rest position; phi is positive nose-up.
template <class T>
struct FlatState {
  T zk, phi, z1, z2;
  T dzk, dphi, dz1, dz2;
};

/// Rail height [m] and its rate [m/s] under the wheels 1 to 4, counted from the leading one.
template <class T>
struct FlatRail {
  T eta1, eta2, eta3, eta4;
  T deta1, deta2, deta3, deta4;
};

/// (2) bounce of the carbody [m/s^2]. Paper: mk zk'' + bk (2 zk' - z1' - z2') + ck (2 zk - z1 - z2) = 0
template <class T>
[[nodiscard, gnu::always_inline]] inline T carbodyBounce(const FlatCoefficients<T>& p, const FlatState<T>& s) {
  return -p.inv_mk * ((p.bk1 * (s.dzk - s.dz1 + p.lf * s.dphi) + p.ck1 * (s.zk - s.z1 + p.lf * s.phi)) +
                      (p.bk2 * (s.dzk - s.dz2 - p.lr * s.dphi) + p.ck2 * (s.zk - s.z2 - p.lr * s.phi)));  // (2)
}

/// (3) pitch of the carbody [rad/s^2].
/// Paper: Jk phi'' + ak bk (2 ak phi' - z1' + z2') + ak ck (2 ak phi - z1 + z2) = 0; kg phi is ours.
template <class T>
[[nodiscard, gnu::always_inline]] inline T carbodyPitch(const FlatCoefficients<T>& p, const FlatState<T>& s) {
  return -p.inv_Jk *
         (p.lf * (p.bk1 * (s.dzk - s.dz1 + p.lf * s.dphi) + p.ck1 * (s.zk - s.z1 + p.lf * s.phi)) -
          p.lr * (p.bk2 * (s.dzk - s.dz2 - p.lr * s.dphi) + p.ck2 * (s.zk - s.z2 - p.lr * s.phi)) +
          p.kg * s.phi);  // (3)
}

/// What the rail does to the front bogie through its two primaries [N]: the right side of (4).
/// Apart from (4), because two stages of a Runge-Kutta step and two neighbouring steps share it.
template <class T>
[[nodiscard, gnu::always_inline]] inline T frontRailForce(const FlatCoefficients<T>& p, const FlatRail<T>& rail) {
  return p.bb1 * rail.deta1 + p.bb2 * rail.deta2 + p.cb1 * rail.eta1 + p.cb2 * rail.eta2;
}

/// The same of the rear bogie [N]: the right side of (5).
template <class T>
[[nodiscard, gnu::always_inline]] inline T rearRailForce(const FlatCoefficients<T>& p, const FlatRail<T>& rail) {
  return p.bb3 * rail.deta3 + p.bb4 * rail.deta4 + p.cb3 * rail.eta3 + p.cb4 * rail.eta4;
}

/// (4) bounce of the front bogie [m/s^2]. Paper: mb z1'' - bk (zk' - z1' + ak phi') - ck (zk - z1 + ak phi)
///     + 2 bb z1' + 2 cb z1 = bb (eta1' + eta2') + cb (eta1 + eta2)
/// @param rail_force  frontRailForce()
template <class T>
[[nodiscard, gnu::always_inline]] inline T frontBogieBounce(const FlatCoefficients<T>& p, const FlatState<T>& s,
                                                            const T& rail_force) {
  return p.inv_m1 *
         ((p.bk1 * (s.dzk - s.dz1 + p.lf * s.dphi) + p.ck1 * (s.zk - s.z1 + p.lf * s.phi)) -
          (p.bb12 * s.dz1 + p.cb12 * s.z1) + rail_force);  // (4)
}
template <class T>
[[nodiscard, gnu::always_inline]] inline T frontBogieBounce(const FlatCoefficients<T>& p, const FlatState<T>& s,
                                                            const FlatRail<T>& rail) {
  return frontBogieBounce(p, s, frontRailForce(p, rail));
}

/// (5) bounce of the rear bogie [m/s^2]. Paper, corrected: mb z2'' - bk (zk' - z2' - ak phi') - ck (zk - z2 - ak phi)
///     + 2 bb z2' + 2 cb z2 = bb (eta3' + eta4') + cb (eta3 + eta4)
/// @param rail_force  rearRailForce()
template <class T>
[[nodiscard, gnu::always_inline]] inline T rearBogieBounce(const FlatCoefficients<T>& p, const FlatState<T>& s,
                                                           const T& rail_force) {
  return p.inv_m2 *
         ((p.bk2 * (s.dzk - s.dz2 - p.lr * s.dphi) + p.ck2 * (s.zk - s.z2 - p.lr * s.phi)) -
          (p.bb34 * s.dz2 + p.cb34 * s.z2) + rail_force);  // (5)
}
template <class T>
[[nodiscard, gnu::always_inline]] inline T rearBogieBounce(const FlatCoefficients<T>& p, const FlatState<T>& s,
                                                           const FlatRail<T>& rail) {
  return rearBogieBounce(p, s, rearRailForce(p, rail));
}

/// One coupling between the carbodies of two neighbours in a train.
template <class T>
struct FlatCouplingCoefficients {
  T c, b;         // [N/m, N s/m]
  T arm_ahead;    // [m] its end behind the CG of the carbody ahead
  T arm_behind;   // [m] its end ahead of the CG of the carbody behind
};

/// Force of a coupling [N], positive in elongation: it pulls the carbody ahead down and the one behind up.
///     F = c d + b d',  d = (zk - arm_ahead phi) ahead - (zk + arm_behind phi) behind    docs/theory/vertical.md (8.1)
template <class T>
[[nodiscard, gnu::always_inline]] inline T couplingForce(const FlatCouplingCoefficients<T>& q,
                                                         const FlatState<T>& ahead, const FlatState<T>& behind) {
  return q.b * ((ahead.dzk - q.arm_ahead * ahead.dphi) - (behind.dzk + q.arm_behind * behind.dphi)) +
         q.c * ((ahead.zk - q.arm_ahead * ahead.phi) - (behind.zk + q.arm_behind * behind.phi));  // (8.1)
}

/// (2) in a train: bounce of a carbody [m/s^2] between the forces of the couplings at its ends; 0 where there is none.
template <class T>
[[nodiscard, gnu::always_inline]] inline T carbodyBounceInTrain(const FlatCoefficients<T>& p, const FlatState<T>& s,
                                                                T force_at_front, T force_at_rear) {
  return carbodyBounce(p, s) + p.inv_mk * (force_at_front - force_at_rear);  // (8.2)
}

/// (3) in a train: pitch of a carbody [rad/s^2].
/// @param front_arm, rear_arm  [m] from its CG forward to the front coupling, back to the rear one
template <class T>
[[nodiscard, gnu::always_inline]] inline T carbodyPitchInTrain(const FlatCoefficients<T>& p, const FlatState<T>& s,
                                                               T force_at_front, T front_arm, T force_at_rear,
                                                               T rear_arm) {
  return carbodyPitch(p, s) + p.inv_Jk * (front_arm * force_at_front + rear_arm * force_at_rear);  // (8.3)
}

}  // namespace vehicle
