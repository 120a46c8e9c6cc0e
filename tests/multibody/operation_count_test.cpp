// How many operations an evaluation takes, beside the paper's formulas.
#include <gtest/gtest.h>

#include "multibody/dynamics/operation_count.hpp"
#include "multibody/dynamics/two_step.hpp"
#include "multibody/system/constants.hpp"
#include "multibody/system/eigen_conversion.hpp"
#include "multibody_support/counted.hpp"
#include "multibody_support/plain_two_step.hpp"
#include "multibody_support/prepared.hpp"
#include "multibody_support/random_instant.hpp"

namespace multibody {

// For the messages of googletest, which looks for it here.
static std::ostream& operator<<(std::ostream& out, const Operations& line) {
  return out << line.per_body << " L + " << line.fixed;
}

namespace test {
namespace {

// From the counts at two numbers of bodies; a third has to lie on the line.
template <class F>
Operations line_of(F count) {
  const int two = count(2), four = count(4);
  const Operations line{(four - two) / 2, two - (four - two)};
  EXPECT_EQ(count(7), line.of(7));
  return line;
}

template <class F>
int counted(F f) {
  Counted::count() = {};
  f();
  return Counted::count().total();
}

std::vector<Counted> numbers(const std::vector<double>& v) {
  return {v.begin(), v.end()};
}
Vec3<Counted> counting(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

// The resolution that programs use: state in (quaternions, angles), all
// accelerations out, with active forces and friction moments.
struct Exploiting {
  Exploiting(Mix mix, int bodies)
      : prepared(prepare(random_instant(mix, bodies, 1))),
        constants(prepared.system),
        two_step(constants),
        state(numbers(prepared.state)),
        change(3 * bodies, Counted(1e-3)),
        carrier{counting(prepared.forces.carrier.force),
                counting(prepared.forces.carrier.moment)} {
    for (const auto& body : prepared.forces.bodies) {
      for (const auto& v : {body.force, body.moment, body.friction}) {
        for (const double x : {v.x, v.y, v.z}) forces.emplace_back(x);
      }
    }
  }
  int evaluate() {
    return counted([&] {
      two_step.evaluate(state.data(), carrier, forces.data());
      take_accelerations();
    });
  }
  int increment() {
    evaluate();
    return counted([&] {
      two_step.add_friction(change.data());
      take_accelerations();
    });
  }
  void take_accelerations() const {
    two_step.relative_accelerations([](int, const Vec3<Counted>&) {});
  }

  Prepared prepared;
  SystemConstants constants;
  TwoStep<Counted> two_step;
  std::vector<Counted> state, forces, change;
  CarrierActiveForces<Counted> carrier;
};

template <class T>
typename PlainTwoStep<T>::Input plain_input(const Instant& instant) {
  typename PlainTwoStep<T>::Input in;
  in.w0 = instant.angular_velocity.cast<T>();
  in.force = instant.active_force.cast<T>();
  in.moment = instant.active_moment_com.cast<T>();
  for (const BodyInstant& body : instant.bodies) {
    const bool axis = body.body.kind == HingeKind::axis;
    const Eigen::Matrix3d& b = body.body.hinge_to_body;
    const Eigen::Matrix3d c =
        axis ? axis_rotation(body.body, body.angle) : body.rotation;
    const Eigen::Vector3d relative =
        axis ? Eigen::Vector3d(body.angle_rate * b.col(2))
             : body.relative_angular_velocity;
    const Eigen::Vector3d friction =
        axis ? Eigen::Vector3d(b * body.friction_moment) : body.friction_moment;
    in.bodies.push_back({c.cast<T>(), relative.cast<T>(),
                         body.active_force.cast<T>(),
                         body.active_moment_com.cast<T>(), friction.cast<T>()});
  }
  return in;
}

// The formulas as the paper writes them, rotations given.
int plain(Mix mix, int bodies) {
  const Instant instant = random_instant(mix, bodies, 1);
  PlainTwoStep<Counted> two_step(instant);
  const auto input = plain_input<Counted>(instant);
  return counted([&] { two_step.evaluate(input); });
}

TEST(OperationCount, PlainFormulasAgreeWithTheResolution) {
  for (const Mix mix : {Mix::balls, Mix::axes}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Instant instant = random_instant(mix, 4, seed);
      PlainTwoStep<double> two_step(instant);
      two_step.evaluate(plain_input<double>(instant));
      const InstantResult expected = evaluate(instant);
      const auto error = [](const Eigen::Vector3d& a,
                            const Eigen::Vector3d& b) {
        return (a - b).norm() / (1 + b.norm());
      };
      EXPECT_LT(error(two_step.linear, expected.acceleration_minus_gravity),
                1e-12);
      EXPECT_LT(error(two_step.angular, expected.angular_acceleration), 1e-12);
      for (int i = 0; i < 4; ++i) {
        EXPECT_LT(error(two_step.relative(i),
                        expected.bodies[i].relative_angular_acceleration),
                  1e-11);
      }
    }
  }
}

// Counts printed by hinge-table and in libcontact/docs/internals/equations.md.
TEST(OperationCount, IsWhatTheProgramsSay) {
  const auto evaluation = [](Mix mix) {
    return line_of([=](int l) { return Exploiting(mix, l).evaluate(); });
  };
  const auto increment = [](Mix mix) {
    return line_of([=](int l) { return Exploiting(mix, l).increment(); });
  };
  const auto as_written = [](Mix mix) {
    return line_of([=](int l) { return plain(mix, l); });
  };
  EXPECT_EQ(evaluation(Mix::balls), evaluation_of_balls);
  EXPECT_EQ(evaluation(Mix::axes), evaluation_of_axes);
  EXPECT_EQ(increment(Mix::balls), iteration_of_balls);
  EXPECT_EQ(increment(Mix::axes), iteration_of_axes);
  EXPECT_EQ(as_written(Mix::balls), (Operations{495, 303}));
  EXPECT_EQ(as_written(Mix::axes), (Operations{805, 303}));
}

}  // namespace
}  // namespace test
}  // namespace multibody
