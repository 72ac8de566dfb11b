#include "libvehicle/ensemble/isa.h"

#include "libvehicle/ensemble/kernel.h"

namespace vehicle {
namespace {

#if defined(__clang__) && defined(__x86_64__)
// clang 14 asks for single features and knows no levels. Every processor with these has the others of its level.
bool isV3() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
         __builtin_cpu_supports("bmi2");
}
// The masked assignment of libstdc++ 12's simd, stdx::where(mask, x) = y, assigns nothing where clang 14 compiles it for
// AVX-512, -O1 and -O3 alike: designs would fail. g++ compiles the same lines rightly.
bool isV4() { return false; }
#elif defined(__x86_64__)
bool isV3() { return __builtin_cpu_supports("x86-64-v3") != 0; }
bool isV4() { return __builtin_cpu_supports("x86-64-v4") != 0; }
#endif

}  // namespace

bool supports(Isa isa) {
#if defined(__x86_64__)
  switch (isa) {
    case Isa::kBaseline:
      return true;
    case Isa::kV3:
      return isV3();
    case Isa::kV4:
      return isV4();
  }
  return false;
#else
  return isa == Isa::kBaseline;
#endif
}

Isa bestIsa() { return supportedIsas().back(); }

std::vector<Isa> supportedIsas() {
  std::vector<Isa> found;
  for (const Isa isa : {Isa::kBaseline, Isa::kV3, Isa::kV4}) {
    if (supports(isa)) found.push_back(isa);
  }
  return found;
}

std::string_view nameOf(Isa isa) {
  switch (isa) {
    case Isa::kBaseline:
      return "baseline";
    case Isa::kV3:
      return "v3";
    case Isa::kV4:
      return "v4";
  }
  return "unknown";
}

int lanesOf(Isa isa) { return ensemble::kernelsOf(isa).lanes; }

namespace ensemble {

const Kernels& kernelsOf(Isa isa) {
#if defined(__x86_64__)
  if (isa == Isa::kV4) return v4::kKernels;
  if (isa == Isa::kV3) return v3::kKernels;
#endif
  return v2::kKernels;
}

}  // namespace ensemble
}  // namespace vehicle
