#pragma once

#include <string>

#include "libcontact/base/error.hpp"

namespace contact::test {

/// What contact::Error says when `call` runs; "(no error)" if it does not
/// throw one.
template <class Call>
std::string error_message(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "(no error)";
}

}  // namespace contact::test

/// The statement throws contact::Error with this message.
#define EXPECT_ERROR(statement, message) \
  EXPECT_EQ(::contact::test::error_message([&] { statement; }), message)
