// A C++17 program, like Simbody's: the moment that a joint holds at rest.
#include <libcontact/c/contact.h>

#include <cstdio>
#include <memory>

int main() {
  contact_joint_numbers numbers = {};
  numbers.radius = 0.014;
  numbers.radial_clearance = 100e-6;
  numbers.inner = {230e9, 0.3};
  numbers.outer = {1e9, 0.4};
  numbers.coefficient = 0.0587;
  contact_joint* made = nullptr;
  if (contact_joint_make(&numbers, &made) != CONTACT_OK) {
    std::puts(contact_last_message());
    return 1;
  }
  const std::unique_ptr<contact_joint, void (*)(contact_joint*)> joint(
      made, contact_joint_free);
  const contact_hold hold = {{0, 0, 2000}, {0.5, 0, 0}, {}};
  contact_rest rest;
  if (contact_joint_at_rest(joint.get(), &hold, nullptr, &rest)) return 1;
  std::printf("C++ %ld: utilisation %.4f\n", __cplusplus, rest.utilisation);
}
