#pragma once

#include "c/door.hpp"
#include "separation/c/run.h"

namespace contact::test {

using CRun = std::unique_ptr<contact_run, void (*)(contact_run*)>;

inline CRun c_run(const std::string& file,
                  const contact_setting* settings = nullptr,
                  std::size_t count = 0) {
  contact_run* run = nullptr;
  EXPECT_EQ(contact_run_open(file.c_str(), settings, count, &run), CONTACT_OK)
      << contact_last_message();
  return {run, contact_run_free};
}

}  // namespace contact::test
