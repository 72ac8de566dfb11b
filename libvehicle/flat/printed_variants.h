#pragma once

#include "libvehicle/flat/equations.h"

// The equations (2), (4) and (5) of the source paper to the letter, misprints included; (3) is right as printed.
// They are kept for teaching and for the errata page (docs/theory/errata.md), whose row numbers stand beside each
// term. Nothing that is meant to be right may call them. Same rules as in equations.h.

namespace vehicle {

/// The paper's coefficients: the vehicle is symmetric, each letter has one value.
template <class T>
struct PaperCoefficients {
  T inv_mk, inv_Jk, inv_mb;  // [1/kg, 1/(kg m^2)]
  T inv_cb;                  // 1 / cb, the inertia that (4) prints; errata row 2
  T ak;                      // [m] half the distance of the pivots
  T ck, bk;                  // [N/m, N s/m] secondary, per bogie
  T cb, bb;                  // [N/m, N s/m] primary, per axle
};

/// (2) as printed: the spring is ck 2 (zk - z1 - z2), errata row 1; the damper is right.
template <class T>
[[nodiscard, gnu::always_inline]] inline T printedCarbodyBounce(const PaperCoefficients<T>& p, const FlatState<T>& s) {
  const T two = T(2);
  return -p.inv_mk * (p.bk * (two * s.dzk - s.dz1 - s.dz2) + p.ck * two * (s.zk - s.z1 - s.z2));
}

/// (3) as printed, which is right.
template <class T>
[[nodiscard, gnu::always_inline]] inline T printedCarbodyPitch(const PaperCoefficients<T>& p, const FlatState<T>& s) {
  const T two = T(2);
  return -p.inv_Jk * (p.ak * p.bk * (two * p.ak * s.dphi - s.dz1 + s.dz2) +
                      p.ak * p.ck * (two * p.ak * s.phi - s.z1 + s.z2));
}

/// (4) as printed: the spring has the index of the other bogie and the primary's coefficient, errata rows 3 and 4.
/// @param inv_inertia  inv_cb to the letter (row 2); inv_mb where only the inertia is corrected
template <class T>
[[nodiscard, gnu::always_inline]] inline T printedFrontBogieBounce(const PaperCoefficients<T>& p, const FlatState<T>& s,
                                                                   const FlatRail<T>& rail, T inv_inertia) {
  const T two = T(2);
  return inv_inertia * (p.bk * (s.dzk - s.dz1 + p.ak * s.dphi) + p.cb * (s.zk - s.z2 + p.ak * s.phi) -
                        two * p.bb * s.dz1 - two * p.cb * s.z1 + p.bb * (rail.deta1 + rail.deta2) +
                        p.cb * (rail.eta1 + rail.eta2));
}

/// (5) as printed: the secondary has the primary's coefficients (rows 5, 6) and the front's signs (row 7).
template <class T>
[[nodiscard, gnu::always_inline]] inline T printedRearBogieBounce(const PaperCoefficients<T>& p, const FlatState<T>& s,
                                                                  const FlatRail<T>& rail) {
  const T two = T(2);
  return p.inv_mb * (p.bb * (s.dzk - s.dz2 + p.ak * s.dphi) + p.cb * (s.zk - s.z2 + p.ak * s.phi) -
                     two * p.bb * s.dz2 - two * p.cb * s.z2 + p.bb * (rail.deta3 + rail.deta4) +
                     p.cb * (rail.eta3 + rail.eta4));
}

}  // namespace vehicle
