#include "separation/case/identity.hpp"

namespace separation {

std::string identity(const Case& c) {
  std::string text;
  for (const Body& body : c.bodies) {
    for (const HingeJoint& joint : body.hinge.joints) {
      text += joint.joint.canonical_text();
    }
  }
  return text + c.content;
}

}  // namespace separation
