#include "libcontact/c/float_environment.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace contact::c {
namespace {

// x86 has two environments. The one of vectors, for nearly all arithmetic, is
// read and written in 5 ns, the other, of long doubles, in 100: it is left
// alone if it is in its initial state, except for flags.
#if defined(__x86_64__)
constexpr unsigned vectors_as_started = 0x1f80;
constexpr unsigned short control_as_started = 0x037f;
constexpr unsigned short flags = 0x3f;

unsigned short raised_flags() {
  unsigned short status;
  asm volatile("fnstsw %0" : "=a"(status));
  return status & flags;
}

bool is_as_started() {
  unsigned short control;
  asm volatile("fnstcw %0" : "=m"(control));
  return control == control_as_started && raised_flags() == 0;
}

unsigned exchange_vectors(unsigned now) {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(now);
  return before;
}

void clear_flags() {
  if (raised_flags() != 0) asm volatile("fnclex");
}
#else
constexpr unsigned vectors_as_started = 0;
bool is_as_started() { return false; }
unsigned exchange_vectors(unsigned now) { return now; }
void clear_flags() {}
#endif

}  // namespace

FloatEnvironment::FloatEnvironment() noexcept : is_quick_(is_as_started()) {
  if (is_quick_) {
    registers_ = exchange_vectors(vectors_as_started);
    return;
  }
  std::fegetenv(&hosts_);
  std::fesetenv(FE_DFL_ENV);
}

FloatEnvironment::~FloatEnvironment() {
  if (!is_quick_) {
    std::fesetenv(&hosts_);
    return;
  }
  clear_flags();
  exchange_vectors(registers_);
}

}  // namespace contact::c
