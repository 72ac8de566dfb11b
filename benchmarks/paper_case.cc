#include "benchmarks/paper_case.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/model/topology.h"
#include "libvehicle/xml/reader.h"

namespace vehicle::bench {

namespace {

constexpr double kAmplitude1 = 5e-3, kAmplitude3 = 2e-3;                   // [m]
constexpr double kSpeed = 20.0;                                            // [m/s]
constexpr double kFrequency = 2.0 * std::numbers::pi * kSpeed / 25.0;      // [rad/s]
constexpr std::array<double, 4> kDistance = {0.0, 3.0, 7.45, 10.45};       // [m] behind the leading wheel

}  // namespace

double PaperCase::errorOf(const State& end) const {
  double worst = 0.0;
  for (std::size_t i = 0; i < end.size(); ++i) worst = std::max(worst, std::abs(end[i] - exact[i]) / peak[i]);
  return std::isfinite(worst) ? worst : INFINITY;
}

const PaperCase& paperCase() {
  static const PaperCase problem = [] {
    const std::string models = VEHICLE_SOURCE_DIR "/models/";
    const Vehicle vehicle = readVehicle(models + "vehicles/al-oraiqat-2017.xml").orThrow();
    const Scenario scenario = readScenario(models + "scenarios/paper-20mps-extended.xml").orThrow();
    Input input = inputOf(scenario, topologyOf(vehicle), scenario.run.speed);
    Schedule every_step(input, 1e-3);
    Schedule whole(input, durationOf(scenario));
    PaperCase made{buildFlatForm(compile(vehicle, scenario.gravity)), std::move(input), std::move(every_step),
                   std::move(whole)};
    const State rest{};
    runExact({*made.form, made.input, made.every_step, rest}, [&](int, int, double, std::span<const double> x) {
      for (std::size_t i = 0; i < x.size(); ++i) made.peak[i] = std::max(made.peak[i], std::abs(x[i]));
      std::copy(x.begin(), x.end(), made.exact.begin());
      return true;
    });
    return made;
  }();
  return problem;
}

OneSincosRail::OneSincosRail() {
  for (std::size_t j = 0; j < kDistance.size(); ++j) {
    const double angle = kFrequency * kDistance[j] / kSpeed;
    cos_delay_[j] = std::cos(angle);
    sin_delay_[j] = std::sin(angle);
    cos_delay3_[j] = std::cos(3.0 * angle);
    sin_delay3_[j] = std::sin(3.0 * angle);
  }
}

void OneSincosRail::operator()(double t, double* u) const {
  const double s = std::sin(kFrequency * t);
  const double c = std::cos(kFrequency * t);
  const double s3 = s * (3.0 - 4.0 * s * s);
  const double c3 = c * (4.0 * c * c - 3.0);
  for (std::size_t j = 0; j < kDistance.size(); ++j) {
    const double sj = s * cos_delay_[j] - c * sin_delay_[j];
    const double cj = c * cos_delay_[j] + s * sin_delay_[j];
    const double s3j = s3 * cos_delay3_[j] - c3 * sin_delay3_[j];
    const double c3j = c3 * cos_delay3_[j] + s3 * sin_delay3_[j];
    u[j] = kAmplitude1 * sj + kAmplitude3 * s3j;
    u[4 + j] = kFrequency * (kAmplitude1 * cj + 3.0 * kAmplitude3 * c3j);
  }
}

}  // namespace vehicle::bench
