#include "libcontact/base/number.hpp"

#ifndef __cpp_lib_to_chars
#include <locale.h>  // NOLINT(modernize-deprecated-headers): POSIX's newlocale
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): strtod_l
#ifdef __APPLE__
#include <xlocale.h>  // both of them
#endif

#include <cmath>
#include <string>
#include <system_error>
#endif

namespace contact::detail {

#ifdef __cpp_lib_to_chars

std::from_chars_result number_from(const char* first, const char* last,
                                   double& value) {
  return std::from_chars(first, last, value);
}

#else

namespace {

// The text without what strtod takes and from_chars does not.
std::string readable(const char* first, const char* last) {
  std::string text(first, last);
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  if (text.find_first_of("0123456789.iInN", sign) != sign) return {};
  const std::size_t x = text.find_first_of("xX", sign);
  if (x == sign + 1 && text[sign] == '0') text.resize(x);
  return text;
}

}  // namespace

std::from_chars_result number_from(const char* first, const char* last,
                                   double& value) {
  static const locale_t c_locale = newlocale(LC_ALL_MASK, "C", nullptr);
  const std::string text = readable(first, last);
  char* stop = nullptr;
  const double number = strtod_l(text.c_str(), &stop, c_locale);
  const auto size = stop - text.c_str();
  if (size == 0) return {first, std::errc::invalid_argument};
  const bool is_infinity = text.find_first_of("iI") < 2;
  if (std::isinf(number) && !is_infinity) {
    return {first + size, std::errc::result_out_of_range};
  }
  // Rounding to 0 of digits other than 0 is an underflow.
  if (number == 0 &&
      text.substr(0, static_cast<std::size_t>(size))
              .find_first_of("123456789") < text.find_first_of("eE")) {
    return {first + size, std::errc::result_out_of_range};
  }
  value = number;
  return {first + size, std::errc()};
}

#endif

std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = number_from(text.data(), end, value);
  if (error != std::errc() || stop != end) return {};
  return value;
}

}  // namespace contact::detail
