// Ensemble kernels for x86-64-v3, 4 designs at once.
#if defined(__x86_64__) && !(defined(__AVX2__) && defined(__FMA__))
#error "kernel_v3.cc is to be compiled with -march=x86-64-v3"
#endif
#define VEHICLE_ENSEMBLE_ISA v3
#define VEHICLE_ENSEMBLE_LANES 4
#define VEHICLE_ENSEMBLE_PACKS 2
#include "libvehicle/ensemble/kernel.inc"
