#pragma once

// VEHICLE_SANITIZED: built for the address or the thread sanitizer. g++ says so by macros, clang by features.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define VEHICLE_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define VEHICLE_SANITIZED
#endif
#endif
