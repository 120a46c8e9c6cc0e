#pragma once

#include <string>

#include "hosts/fmu/model.hpp"

namespace hinge_fmu {

/// Text of modelDescription.xml.
struct Description {
  std::string name;        ///< modelName
  std::string identifier;  ///< name of the shared object
  std::string token;
  int version;          ///< 2 or 3: of FMI
  bool model_exchange;  ///< beside co-simulation; FMI 2.0 alone
  double stop_time;     ///< s; 0: none

  std::string text(const contact_hosts::fmu::Model& model) const;
};

/// `text` as an attribute of XML; characters that XML does not have are left
/// out.
std::string escaped(const std::string& text);

}  // namespace hinge_fmu
