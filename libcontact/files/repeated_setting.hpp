#pragma once

#include "libcontact/base/error.hpp"

namespace contact {

/// Two settings of one key, be it under two names: "KEY = VALUE conflicts with
/// OTHER".
class RepeatedSetting : public Error {
 public:
  using Error::Error;
};

}  // namespace contact
