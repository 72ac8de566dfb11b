// Ensemble kernels for x86-64-v4, 8 designs at once.
#if defined(__x86_64__) && !defined(__AVX512F__)
#error "kernel_v4.cc is to be compiled with -march=x86-64-v4"
#endif
#define VEHICLE_ENSEMBLE_ISA v4
#define VEHICLE_ENSEMBLE_LANES 8
#define VEHICLE_ENSEMBLE_PACKS 1
#include "libvehicle/ensemble/kernel.inc"
