// Ensemble kernels for x86-64, 2 designs at once.
#define VEHICLE_ENSEMBLE_ISA v2
#define VEHICLE_ENSEMBLE_LANES 2
#define VEHICLE_ENSEMBLE_PACKS 1
#include "libvehicle/ensemble/kernel.inc"
