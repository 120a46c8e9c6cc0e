#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "libcontact/base/error.hpp"

namespace contact::test {

/// Message of contact::Error when `call` runs; "(no error)" if it throws none.
template <class Call>
std::string error_message(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "(no error)";
}

/// Whether the part is in the text; else it shows the text.
inline testing::AssertionResult has_text(std::string_view text,
                                         std::string_view part) {
  return testing::AssertionResult(text.find(part) != text.npos) << text;
}

}  // namespace contact::test

/// The statement throws contact::Error with this message.
#define EXPECT_ERROR(statement, message) \
  EXPECT_EQ(::contact::test::error_message([&] { statement; }), message)
