// Ensemble kernels for x86-64-v3, 4 designs at once.
#define VEHICLE_ENSEMBLE_ISA v3
#define VEHICLE_ENSEMBLE_LANES 4
#include "libvehicle/ensemble/kernel.inc"
