#pragma once

#include <string>

#include "hosts/fmu/model.hpp"

namespace hinge_fmu {

/// Text of modelDescription.xml.
struct Description {
  std::string name;        ///< of the model
  std::string identifier;  ///< name of the shared object
  std::string token;
  int version;          ///< of FMI: 2 or 3
  bool model_exchange;  ///< of FMI 2.0, beside co-simulation
  double stop_time;     ///< s; 0: none

  std::string text(const contact_hosts::fmu::Model& model) const;
};

/// `text` as an attribute of XML; characters that XML does not have are left
/// out.
std::string escaped(const std::string& text);

}  // namespace hinge_fmu
