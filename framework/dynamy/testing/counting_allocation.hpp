/// Definitions that count allocations: to be included by exactly one source file of a test program
/// (allocation_counter.hpp).
///
/// With glibc, malloc itself is wrapped: Eigen does not go through operator new. Elsewhere, and
/// under a sanitizer that owns malloc, operator new is replaced.
#pragma once
#include <cstdlib>
#include <dynamy/testing/allocation_counter.hpp>
#include <new>

namespace dynamy::detail {
inline const bool kCounting = (allocationsAreCounted = true);
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

extern "C" {
void* __libc_malloc(std::size_t);               // NOLINT
void* __libc_realloc(void*, std::size_t);       // NOLINT
void* __libc_calloc(std::size_t, std::size_t);  // NOLINT
void* malloc(std::size_t n) {
  dynamy::detail::allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(n);
}
void* realloc(void* p, std::size_t n) {
  dynamy::detail::allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_realloc(p, n);
}
void* calloc(std::size_t n, std::size_t size) {
  dynamy::detail::allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_calloc(n, size);
}
}

#else

// Not inlined: otherwise gcc sees that free() gets memory from new, and warns.
[[gnu::noinline]] void* operator new(std::size_t n) {
  dynamy::detail::allocations.fetch_add(1, std::memory_order_relaxed);
  if (void* p = std::malloc(n > 0 ? n : 1)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t n, const std::nothrow_t&) noexcept {
  dynamy::detail::allocations.fetch_add(1, std::memory_order_relaxed);
  return std::malloc(n > 0 ? n : 1);
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

#endif
