#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "libcontact/c/contact.h"

/// Helpers of the tests of the C interface.
namespace contact::test {

using CJoint = std::unique_ptr<contact_joint, void (*)(contact_joint*)>;

inline CJoint c_joint(const std::string& file) {
  contact_joint* joint = nullptr;
  EXPECT_EQ(contact_joint_read(file.c_str(), nullptr, 0, &joint), CONTACT_OK)
      << contact_last_message();
  return {joint, contact_joint_free};
}

/// Expects a call to fail with this status and message.
inline void expect_failure(contact_status status, contact_status expected,
                           const std::string& message) {
  EXPECT_EQ(status, expected) << message;
  EXPECT_EQ(contact_last_message(), message);
}

}  // namespace contact::test
