#include "libvehicle/integrate/step_control.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace vehicle {
namespace {

constexpr double kSafety = 0.9;
constexpr double kBeta = 0.04;
constexpr double kMostGrowth = 5.0;
constexpr double kMostShrinking = 0.1;

[[noreturn]] void refuse(const char* method, const char* name, double value, const char* rule) {
  std::ostringstream message;
  message << method << ": " << name << " = " << value << ", must be " << rule;
  throw std::invalid_argument(message.str());
}

}  // namespace

StepControl::StepControl(int order) : exponent_(1.0 / order) {}

double StepControl::afterAccepted(double h, double error_norm) {
  const double norm = std::max(error_norm, 1e-10);
  double factor = kSafety * std::pow(norm, -(exponent_ - 0.75 * kBeta)) * std::pow(last_norm_, kBeta);
  factor = std::clamp(factor, kMostShrinking, rejected_ ? 1.0 : kMostGrowth);
  last_norm_ = std::max(norm, 1e-4);
  rejected_ = false;
  return factor * h;
}

double StepControl::afterRejected(double h, double error_norm) {
  rejected_ = true;
  if (!std::isfinite(error_norm)) return kMostShrinking * h;
  return std::max(kMostShrinking, kSafety * std::pow(error_norm, -exponent_)) * h;
}

double longestStep(const InputSegment& segment) {
  double fastest = segment.fastestSampled();
  for (const double w : segment.angular_frequency) fastest = std::max(fastest, w);
  if (fastest == 0.0) return std::numeric_limits<double>::infinity();
  return 0.25 * 2.0 * std::numbers::pi / fastest;
}

void checkAccuracy(const char* method, const Accuracy& accuracy) {
  if (!(accuracy.relative >= 1e-14 && accuracy.relative < 1.0)) {
    refuse(method, "relative tolerance", accuracy.relative, "1e-14 or more and below 1");
  }
  if (!(accuracy.absolute > 0.0 && std::isfinite(accuracy.absolute))) {
    refuse(method, "absolute tolerance", accuracy.absolute, "finite and > 0");
  }
  if (!(accuracy.max_step >= 0.0 && std::isfinite(accuracy.max_step))) {
    refuse(method, "max_step [s]", accuracy.max_step, "finite and >= 0");
  }
}

}  // namespace vehicle
