#include "hosts/fmu/model.hpp"

namespace contact_hosts::fmu {

std::unique_ptr<Model> make_model(const std::string& resources) {
  return case_model(resources);
}

}  // namespace contact_hosts::fmu
