// Ensemble kernels for x86-64-v4, 8 designs at once.
#define VEHICLE_ENSEMBLE_ISA v4
#define VEHICLE_ENSEMBLE_LANES 8
#include "libvehicle/ensemble/kernel.inc"
