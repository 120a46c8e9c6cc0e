// The page's door to C++: texts in, JSON out, valid until the next call.
#include <string>

#include "page/answer.hpp"

namespace {

std::string last;

page::Calculator& calculator() {
  static page::Calculator it("/data");
  return it;
}

}  // namespace

extern "C" {

const char* page_choices() {
  last = calculator().choices();
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
