// The page's door to C++: texts in, JSON out, valid until the next call.
#include <string>

#include "libcontact/base/simd.hpp"
#include "page/answer.hpp"

// WebAssembly's vectors have two doubles.
static_assert(contact::detail::native_lanes == 2);

namespace {

std::string last;

page::Calculator& calculator() {
  static page::Calculator it("/data");
  return it;
}

}  // namespace

extern "C" {

const char* page_choices() {
  last = page::choices();
  return last.c_str();
}

const char* page_answer(const char* joint, const char* state) {
  last = calculator().answer(joint, state);
  return last.c_str();
}

const char* page_curves(const char* joint, const char* state) {
  last = calculator().curves(joint, state);
  return last.c_str();
}
}
