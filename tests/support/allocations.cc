#include "tests/support/allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/support/sanitizers.h"

namespace {
std::atomic<long> count{0};
}

long vehicle::test::allocations() { return count; }

#ifdef VEHICLE_SANITIZED
void* operator new(std::size_t size) {
  ++count;
  if (void* block = std::malloc(size)) return block;
  throw std::bad_alloc();
}
// std::stable_sort asks for its buffer this way and gives it back the ordinary way.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++count;
  return std::malloc(size);
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
#else
// operator new ends in malloc, and Eigen calls malloc alone: counting there sees both.
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* malloc(std::size_t size) {
  ++count;
  return __libc_malloc(size);
}
#endif
