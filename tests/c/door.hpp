#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "libcontact/c/contact.h"
#include "separation/c/run.h"

/// Helpers of the tests of the C interface.
namespace contact::test {

using CJoint = std::unique_ptr<contact_joint, void (*)(contact_joint*)>;
using CRun = std::unique_ptr<contact_run, void (*)(contact_run*)>;

inline CJoint c_joint(const std::string& file) {
  contact_joint* joint = nullptr;
  EXPECT_EQ(contact_joint_read(file.c_str(), nullptr, 0, &joint), CONTACT_OK)
      << contact_last_message();
  return {joint, contact_joint_free};
}

inline CRun c_run(const std::string& file,
                  const contact_setting* settings = nullptr,
                  std::size_t count = 0) {
  contact_run* run = nullptr;
  EXPECT_EQ(contact_run_open(file.c_str(), settings, count, &run), CONTACT_OK)
      << contact_last_message();
  return {run, contact_run_free};
}

/// A call that fails so, and says so.
inline void expect_failure(contact_status status, contact_status expected,
                           const std::string& message) {
  EXPECT_EQ(status, expected) << message;
  EXPECT_EQ(contact_last_message(), message);
}

}  // namespace contact::test
