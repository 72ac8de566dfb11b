#pragma once

#include <array>
#include <utility>
#include <vector>

// Published vehicles, both sides together: the parameters restate the papers named beside them. The frequencies are
// our own computation in another program (wheels on a rigid rail, bogies that pitch), not published values: an
// independent form to be checked against, to the digits given.
namespace vehicle::test {

struct PublishedVehicle {
  const char* name;
  double carbody_mass, carbody_inertia, half_pivots;  // [kg, kg m^2, m]
  double bogie_mass, bogie_inertia, half_wheelbase;   // [kg, kg m^2, m]
  double primary_stiffness, primary_damping;          // [N/m, N s/m] per axle
  double secondary_stiffness, secondary_damping;      // [N/m, N s/m] per bogie
  std::array<double, 6> undamped_hz;
  std::vector<std::pair<double, double>> damped;  // |lambda| / 2 pi [Hz] and damping ratio; empty: not computed
};

inline const std::vector<PublishedVehicle>& publishedVehicles() {
  static const std::vector<PublishedVehicle> vehicles = {
      // Iwnicki 1998, VSD 30:295-313, doi 10.1080/00423119808969454
      {"manchester-coach",
       32000.0, 1.97e6, 9.5,
       2615.0, 1476.0, 1.28,
       2.44e6, 8000.0, 860000.0, 40000.0,
       {1.0739, 1.2991, 7.4705, 7.4772, 11.7138, 11.7138},
       {{1.0802, 0.1345}, {1.3106, 0.1625}, {7.4114, 0.2406}, {7.4271, 0.2367}, {11.7138, 0.1207}, {11.7138, 0.1207}}},
      // Goicolea 2014, oa.upm.es/43946
      {"ave-s103-ice3-c1",
       47800.0, 1957888.0, 8.6875,
       3500.0, 1715.0, 1.25,
       2.4e6, 20000.0, 700000.0, 40000.0,
       {0.8037, 1.0898, 6.3167, 6.3233, 10.5249, 10.5249},
       {}},
      // Zhai, Wang, Cai 2009, VSD 47(11):1349-1376
      {"chinese-star-power-car",
       59364.2, 1.723e6, 5.73,
       5630.8, 9487.0, 1.5,
       4.7992e6, 60000.0, 1.7716e6, 90000.0,
       {1.1271, 1.1984, 7.1687, 7.1709, 7.5936, 7.5936},
       {}},
      // Zhai, Wang, Cai 2009
      {"zhai-double-deck-coach",
       29600.0, 2.139e6, 9.0,
       1700.0, 1700.0, 1.2,
       1.746e6, 60000.0, 820000.0, 217400.0,
       {1.0638, 1.1260, 8.0325, 8.0346, 8.6559, 8.6559},
       {}},
      // Wu & Yang 2003, Eng. Struct. 25(2):251-265
      {"shinkansen-s300",
       41750.0, 2.08e6, 8.75,
       3040.0, 3930.0, 1.25,
       1.18e6, 39200.0, 530000.0, 90200.0,
       {0.7229, 0.8949, 4.8752, 4.8752, 4.9195, 4.9262},
       {}},
      // Antolin et al. 2013, JSV 332(5):1231-1251
      {"pioneer-R",
       44000.0, 2.74e6, 9.0,
       1700.0, 1700.0, 1.25,
       700000.0, 38000.0, 350000.0, 40000.0,
       {0.5669, 0.6462, 5.1144, 5.1168, 5.7091, 5.7091},
       {}},
      // Antolin et al. 2013
      {"pioneer-M",
       42400.0, 1.0644e6, 9.0,
       3400.0, 7200.0, 1.25,
       1.04e6, 30000.0, 400000.0, 33000.0,
       {0.6318, 1.1291, 3.3814, 3.3814, 4.3076, 4.3294},
       {}},
      // Domenech Monforte 2014 thesis UPV, doi 10.4995/Thesis/10251/36740
      {"eurostar-locomotive",
       51500.0, 1.05e6, 7.0,
       2200.0, 1900.0, 1.5,
       2.6e6, 12000.0, 3.26e6, 90000.0,
       {1.3950, 2.1425, 9.9331, 10.0261, 12.4892, 12.4892},
       {}},
  };
  return vehicles;
}

}  // namespace vehicle::test
