#pragma once

#include <string>

#include "hosts/fmu/model.hpp"

namespace hinge_fmu {

/// Text of modelDescription.xml.
struct Description {
  std::string name;        ///< modelName
  std::string identifier;  ///< name of the shared object
  std::string token;
  int version;          ///< version of FMI: 2 or 3
  bool model_exchange;  ///< in addition to co-simulation; FMI 2.0 only
  double stop_time;     ///< s; 0: none

  std::string text(const contact_hosts::fmu::Model& model) const;
};

/// Escapes `text` for an XML attribute; drops characters that XML does not
/// allow.
std::string escaped(const std::string& text);

}  // namespace hinge_fmu
