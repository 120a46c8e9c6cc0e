// A steel ball joint at theta0 = 60 deg, a = 30 deg; fails unless the numbers
// equal data/reference/friction_integrals.csv.
#include <cmath>
#include <cstdio>
#include <libcontact/contact.hpp>

int main() {
  const contact::FrictionIntegrals friction = contact::friction_integrals(
      60 * contact::degree, contact::SlipAxis::from_degrees(30));
  const contact::ElasticPair steel({2e11, 0.3}, {2e11, 0.3});
  std::printf("chi = %.15f, E = %.6e Pa\n", friction.coefficient.force,
              steel.effective_modulus());
  return std::abs(friction.coefficient.force - 1.0434762830369307) < 1e-14 &&
                 std::abs(steel.effective_modulus() * 0.91 / 2e11 - 1) < 1e-14
             ? 0
             : 1;
}
