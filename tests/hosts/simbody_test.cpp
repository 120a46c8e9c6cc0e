// Hinges of Simbody with friction slide, stop, hold and are released.
#include "hosts/simbody/hinge_friction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "hosts/cup.hpp"

namespace contact::test::simbody_test {
namespace {

using contact_hosts::must;
using contact_hosts::simbody::Fit;
using contact_hosts::simbody::HingeFriction;
using contact_hosts::simbody::Options;
using namespace SimTK;  // NOLINT(google-build-using-namespace)

const std::string folder = CONTACT_HOST_TESTS;
const std::string ball_file = folder + "ball.toml";
const std::string pin_file = folder + "pin.toml";
const std::string star_pin_file = folder + "star_pin.toml";

/// Message of the exception that something throws.
template <class Work>
std::string refused(const Work& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

struct World {
  MultibodySystem system;
  SimbodyMatterSubsystem matter{system};
  GeneralForceSubsystem forces{system};
  HingeFriction friction;
  std::vector<MobilizedBody> bodies;
  State state;

  explicit World(Options options = {}) : friction(system, forces, options) {}
  void weigh(const Vec3& gravity) {
    const Force::UniformGravity weight(forces, matter, gravity);
  }
  void begin() { state = system.realizeTopology(); }
  // Steps of the integrator end at each look.
  void run(double until, double accuracy, double step = 0,
           const std::function<void()>& look = {}) {
    RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(accuracy);
    integrator.setConstraintTolerance(1e-10);
    integrator.setAllowInterpolation(false);
    TimeStepper stepper(system, integrator);
    stepper.initialize(state);
    const double first = state.getTime();
    if (step == 0) step = until - first;
    for (int i = 1; first + (i - 0.5) * step < until; ++i) {
      stepper.stepTo(first + i * step);
      state = integrator.getState();
      system.realize(state, Stage::Acceleration);
      if (look) look();
    }
  }
  double rate() const { return state.getU().normInf(); }
};

/// The pendulum of docs/tutorials/pendulum.md.
template <class Mobilizer = MobilizedBody::Ball>
void add_pendulum(World& w, const Vec3& rate = {0, 1, 0.5}) {
  const Body::Rigid body(
      MassProperties(5, Vec3(0, 0, -0.4), Inertia(0.9, 0.9, 0.02)));
  w.bodies.push_back(Mobilizer(w.matter.Ground(), body));
  w.friction.add(w.bodies.back(), ball_file);
  w.begin();
  w.bodies[0].setQToFitRotation(w.state, Rotation(1, XAxis));
  w.bodies[0].setUToFitAngularVelocity(w.state, rate);
  w.friction.settle(w.state);
}
const Vec3 down(0, 0, -9.81);

/// Links that hang from each other on balls, or on pins about y.
/// @param rubbing  how many have friction
void add_chain(World& w, int links, bool balls, int rubbing = 100) {
  const Body::Rigid body(
      MassProperties(1, Vec3(0.001, 0.0005, -0.25),
                     Inertia(0.02, 0.02, 0.002)
                         .shiftFromMassCenter({0.001, 0.0005, -0.25}, 1)));
  const Rotation z_along_y(-Pi / 2, XAxis);
  for (int i = 0; i < links; ++i) {
    MobilizedBody parent = w.matter.Ground();
    if (i > 0) parent = w.bodies.back();
    const Vec3 at(0, 0, i > 0 ? -0.5 : 0);
    if (balls) {
      w.bodies.push_back(
          MobilizedBody::Ball(parent, Transform(at), body, Transform()));
    } else {
      w.bodies.push_back(MobilizedBody::Pin(parent, Transform(z_along_y, at),
                                            body, Transform(z_along_y)));
    }
    if (i < rubbing) {
      w.friction.add(w.bodies.back(), balls ? ball_file : pin_file);
    }
  }
}

// The page's program, of first order, says 43.61 s; with MuJoCo's steps of 1,
// 0.5, 0.25, 0.125 ms it is 43.608, 43.968, 44.157 and 44.262 s, which leads to
// 44.37 +- 0.02 s.
TEST(HostSimbody, PendulumRestsAndStaysToTheLastBit) {
  World w;
  w.weigh(down);
  add_pendulum(w);
  double rests = 0;
  w.run(45, 1e-7, 0.01, [&] {
    if (rests == 0 && w.bodies[0].isLocked(w.state)) rests = w.state.getTime();
  });
  EXPECT_NEAR(rests, 44.37, 0.03);
  const Vector q = w.state.getQ();
  w.run(45 + 3600, 1e-6);
  EXPECT_EQ((w.state.getQ() - q).normInf(), 0);
  EXPECT_EQ(w.rate(), 0);
}

// Five links on balls, and four panels on pins, an hour on a slope.
TEST(HostSimbody, ChainsRestForAnHourWithoutDrift) {
  for (const bool balls : {true, false}) {
    World w;
    w.weigh({0.002, 0, -9.81});
    add_chain(w, balls ? 5 : 4, balls);
    w.begin();
    const Vector q = w.state.getQ();
    w.friction.settle(w.state);
    w.run(3600, 1e-6);
    EXPECT_EQ((w.state.getQ() - q).normInf(), 0);
    EXPECT_EQ(w.rate(), 0);
  }
}

/// A torque about a mobilizer's axis that grows with time.
class Ramp : public Force::Custom::Implementation {
 public:
  Ramp(const MobilizedBody& body, double first, double slope)
      : body_(body), first_(first), slope_(slope) {}
  void calcForce(const State& s, Vector_<SpatialVec>&, Vector_<Vec3>&,
                 Vector& mobilities) const override {
    body_.applyOneMobilityForce(s, 0, first_ + slope_ * s.getTime(),
                                mobilities);
  }
  double calcPotentialEnergy(const State&) const override { return 0; }

 private:
  MobilizedBody body_;
  double first_, slope_;
};

TEST(HostSimbody, FindsTheOnset) {
  World w;
  w.weigh({0, 0, -9.81});
  add_chain(w, 1, false);
  const double weight = 9.81 * 0.001;  // moment of the link about the pin
  const auto joint = contact_hosts::read_joint(pin_file, "limit", CONTACT_PIN);
  const contact_hold hold = {{0, 0, 9.81}, {0, 1, 0}, {0, 1, 0}};
  contact_rest rest;
  must(contact_joint_at_rest(joint.get(), &hold, nullptr, &rest));
  const double limit = 1 / rest.utilisation;
  // +y turns by -Pi/2 about x to the z of the pin.
  const Force::Custom ramp(w.forces, new Ramp(w.bodies[0], -weight, limit / 2));
  w.begin();
  w.friction.settle(w.state);
  w.run(2 - 1e-7, 1e-8);
  EXPECT_EQ(w.rate(), 0);
  EXPECT_EQ(w.state.getQ()[0], 0);
  w.run(2 + 1e-7, 1e-8);
  EXPECT_GT(w.rate(), 0);
}

// Kinetic and potential energy, and the energy dissipated by friction:
// Simpson's rule over 1 ms, whose own error is below 1e-8.
TEST(HostSimbody, EnergyBookIsClosed) {
  World w({Fit::converged, 1e-12, 1e-7});
  w.weigh({0, 0, -9.81});
  add_chain(w, 5, true);
  w.begin();
  for (int i = 0; i < 5; ++i) {
    w.bodies[i].setUToFitAngularVelocity(w.state, {1 + 0.2 * i, 0.7, -0.5});
  }
  w.friction.settle(w.state);
  const double first = w.system.calcEnergy(w.state);
  const double kinetic = w.system.calcKineticEnergy(w.state);
  std::vector<double> power = {w.friction.power(w.state)};
  w.run(0.2, 1e-9, 1e-3, [&] { power.push_back(w.friction.power(w.state)); });
  double work = 0;
  for (std::size_t i = 0; i + 2 < power.size(); i += 2) {
    work += (power[i] + 4 * power[i + 1] + power[i + 2]) / 3e3;
  }
  EXPECT_LT(work, -0.01);
  EXPECT_NEAR(w.system.calcEnergy(w.state) - first, work, 1e-7 * kinetic);
}

/// Columns of a case at several times by hinge-separation's run.
std::vector<double> separated(const std::string& file,
                              const std::vector<std::string>& columns,
                              const std::vector<double>& times) {
  std::string command = CONTACT_STAR_RUN " " + folder + file + " ";
  for (const std::string& column : columns) command += column + ",";
  for (const double time : times) command += " " + std::to_string(time);
  std::FILE* const said = popen(command.c_str(), "r");
  std::vector<double> found(columns.size() * times.size(), 0.0);
  std::size_t read = 0;
  for (double& value : found) read += std::fscanf(said, "%lf", &value) == 1;
  pclose(said);
  EXPECT_EQ(read, found.size());
  return found;
}

/// The star of star.toml.
void add_star(World& w) {
  MobilizedBody::Free carrier(
      w.matter.Ground(),
      Body::Rigid(MassProperties(900, Vec3(0), Inertia(300, 310, 450))));
  const Vec3 com(0.1, 0.05, 0.7);
  const Body::Rigid arm(MassProperties(
      25, com, Inertia(1.7, 1.68, 0.05).shiftFromMassCenter(com, 25)));
  const Vec3 at[] = {{1, 0, -0.6}, {-0.5, 0.8, -0.6}};
  const Vec3 axes[] = {{0, 1, 0}, {0.8, 0.6, 0}};
  for (int i = 0; i < 2; ++i) {
    const Rotation axis(UnitVec3(axes[i]), ZAxis);
    w.bodies.push_back(MobilizedBody::Pin(carrier, Transform(axis, at[i]), arm,
                                          Transform(axis)));
    w.friction.add(w.bodies.back(), star_pin_file);
  }
  const Vec3 high(0, 0, 0.8);
  w.bodies.push_back(MobilizedBody::Ball(
      carrier, Transform(Vec3(-0.5, -0.8, -0.6)),
      Body::Rigid(MassProperties(
          20, high, Inertia(1.7, 1.68, 0.05).shiftFromMassCenter(high, 20))),
      Transform()));
  w.friction.add(w.bodies.back(), ball_file);
  w.begin();
  carrier.setUToFitAngularVelocity(w.state, {0.02, 0.03, 0.3});
  w.bodies[0].setOneU(w.state, 0, 0.5);
  w.bodies[1].setOneU(w.state, 0, -0.4);
  w.bodies[2].setUToFitAngularVelocity(w.state, {0.2, 0.3, 0.1});
  w.friction.settle(w.state);
}

double angle_of(const World& w, int i) {
  if (i < 2) return w.bodies[i].getOneQ(w.state, 0);
  const Vec3 high(0, 0, 1);
  const Vec3 now = w.bodies[i].getMobilizerTransform(w.state).R() * high;
  return std::atan2((high % now).norm(), dot(high, now));
}

// One motion by two programs that share nothing but the joints; both come from
// their tolerances, 1e-11 and 1e-10.
TEST(HostSimbody, StarMovesAsHingeSeparationHasIt) {
  World w({Fit::converged, 1e-12, 1e-8});
  add_star(w);
  for (const double time : {0.5, 1.0, 2.0, 4.0, 8.0}) {
    w.run(time, 1e-10);
    const std::vector<double> wanted = separated(
        "star.toml", {"a.angle_deg", "b.angle_deg", "c.angle_deg"}, {time});
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(angle_of(w, i), wanted[i] * Pi / 180, 1e-8) << time;
    }
  }
}

/// Columns of the links of chain.toml.
std::vector<std::string> of_links(const std::vector<std::string>& columns) {
  std::vector<std::string> all;
  for (const std::string link : {"a", "b", "c", "d", "e"}) {
    for (const std::string& column : columns)
      all.push_back(link + '.' + column);
  }
  return all;
}

/// Sets the chain from hinge-separation, quaternions of its links first.
/// @param stride  numbers of a link
void set_chain(World& w, const double* links, int stride) {
  Rotation parent;
  Vec3 rate(0);
  for (MobilizedBody& body : w.bodies) {
    const Rotation own(Quaternion(links[0], links[1], links[2], links[3]));
    const Vec3 spin = own * Vec3(links[4], links[5], links[6]);
    body.setQToFitRotation(w.state, Rotation(~parent * own));
    body.setUToFitAngularVelocity(w.state, ~parent * (spin - rate));
    parent = own;
    rate = spin;
    links += stride;
  }
}

// Five balls in a row at 200 instants of their motion: the same friction and
// the same reactions by elimination through the tree and by Simbody's
// accelerations repeated.
TEST(HostSimbody, ChainHasTheFrictionOfHingeSeparation) {
  const std::vector<std::string> columns =
      of_links({"qw", "qx", "qy", "qz", "wx_rad_per_s", "wy_rad_per_s",
                "wz_rad_per_s", "friction_moment_N_m", "reaction_N"});
  constexpr int stride = 9;
  std::vector<double> times;
  for (int i = 0; i < 200; ++i) times.push_back(0.001 * i);
  const std::vector<double> all = separated("chain.toml", columns, times);
  World w({Fit::converged, 1e-13, 1e-7});
  w.weigh(down);
  add_chain(w, 5, true);
  w.begin();
  double moment_off = 0;
  double force_off = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double* const links = &all[k * columns.size()];
    set_chain(w, links, stride);
    if (k == 0) w.friction.settle(w.state);
    w.system.realize(w.state, Stage::Acceleration);
    double largest_moment = 0;
    double largest_force = 0;
    double moment = 0;
    double force = 0;
    for (int i = 0; i < 5; ++i) {
      const double* const link = links + stride * i;
      const double* const m = w.friction.hinge(i).friction_moment;
      const Vec3 reaction =
          w.bodies[i].findMobilizerReactionOnBodyAtMInGround(w.state)[1];
      largest_moment = std::max(largest_moment, link[7]);
      largest_force = std::max(largest_force, link[8]);
      moment =
          std::max(moment, std::abs(Vec3(m[0], m[1], m[2]).norm() - link[7]));
      force = std::max(force, std::abs(reaction.norm() - link[8]));
    }
    moment_off = std::max(moment_off, moment / largest_moment);
    force_off = std::max(force_off, force / largest_force);
  }
  std::printf("moments off by %.1e, forces by %.1e\n", moment_off, force_off);
  EXPECT_LE(moment_off, 1e-9);
  EXPECT_LE(force_off, 1e-9);
}

// A folding arm: two links and a bar, whose end slides on a straight guide.
// With friction in one hinge, as it has one freedom, it comes to rest.
TEST(HostSimbody, HoldsALoop) {
  for (const int rubbing : {1, 2}) {
    World w;
    w.weigh({0.001, 0, -9.81});
    add_chain(w, 2, false, rubbing);
    const Constraint::PointInPlane guide(w.matter.Ground(), UnitVec3(XAxis), 0,
                                         w.bodies[1], Vec3(0, 0, -0.5));
    w.begin();
    if (rubbing == 2) {
      EXPECT_EQ(refused([&] { w.friction.settle(w.state); }),
                "resting hinges of a loop must be no more than its freedoms: "
                "give friction to fewer of them");
      continue;
    }
    w.bodies[0].setOneU(w.state, 0, 0.3);
    w.system.realize(w.state, Stage::Position);
    w.system.projectU(w.state, 1e-10);
    w.friction.settle(w.state);
    w.run(20, 1e-6);
    EXPECT_TRUE(w.bodies[0].isLocked(w.state));
    const Vector q = w.state.getQ();
    w.run(620, 1e-6);
    EXPECT_EQ(w.state.getQ()[0], q[0]);
    // The other hinge stays within the tolerance of the constraint, 1e-10 m.
    EXPECT_LT((w.state.getQ() - q).normInf(), 1e-9);
  }
}

// Forces of a subsystem added after the friction are part of the reactions too,
// by another code path.
TEST(HostSimbody, KnowsForcesOfOtherSubsystems) {
  Rotation turned[2];
  for (const bool later : {false, true}) {
    World w;
    GeneralForceSubsystem other(w.system);
    const Force::UniformGravity weight(later ? other : w.forces, w.matter,
                                       down);
    add_pendulum(w);
    w.run(0.5, 1e-9);
    turned[later] = w.bodies[0].getBodyRotation(w.state);
    EXPECT_GT(w.friction.evaluations(), 0);
  }
  EXPECT_LT((turned[0] - turned[1]).norm(), 1e-9);
}

// A Gimbal is a ball in other coordinates: it slides, comes to rest, stays and
// is released as a Ball, within the integrator's accuracy.
TEST(HostSimbody, GimbalMovesAsABall) {
  for (const Vec3& rate : {Vec3(0, 1, 0.5), Vec3(0)}) {
    World ball, gimbal;
    ball.weigh(down);
    gimbal.weigh(down);
    add_pendulum(ball, rate);
    add_pendulum<MobilizedBody::Gimbal>(gimbal, rate);
    ball.run(1, 1e-9);
    gimbal.run(1, 1e-9);
    EXPECT_LT((ball.bodies[0].getBodyRotation(ball.state) -
               gimbal.bodies[0].getBodyRotation(gimbal.state))
                  .norm(),
              1e-7);
  }
  World w;
  w.weigh(down);
  add_pendulum<MobilizedBody::Gimbal>(w);
  w.run(45, 1e-8);  // 1e-7 is the stop speed
  EXPECT_TRUE(w.bodies[0].isLocked(w.state));
  const Vector q = w.state.getQ();
  w.run(45 + 3600, 1e-6);
  EXPECT_EQ((w.state.getQ() - q).normInf(), 0);
}

TEST(HostSimbody, RefusesGimbalLock) {
  World w;
  w.weigh(down);
  const Body::Rigid body(MassProperties(1, Vec3(0), Inertia(1)));
  w.bodies.push_back(MobilizedBody::Gimbal(w.matter.Ground(), body));
  w.friction.add(w.bodies[0], ball_file);
  w.begin();
  w.bodies[0].setOneQ(w.state, 1, Pi / 2);
  EXPECT_EQ(refused([&] { w.friction.settle(w.state); }),
            "a Gimbal mobilizer with friction must not come to gimbal lock: "
            "use a Ball");
}

// The lagged fit is near the converged one, and asks for no accelerations.
TEST(HostSimbody, LaggedIsNearConverged) {
  double angle[2];
  for (const Fit fit : {Fit::converged, Fit::lagged}) {
    World w({fit, 1e-12, 1e-7});
    w.weigh(down);
    add_pendulum(w);
    w.run(1, 1e-8);
    angle[fit == Fit::lagged] =
        w.bodies[0].getBodyRotation(w.state).convertRotationToAngleAxis()[0];
    EXPECT_EQ(w.friction.evaluations() == 0, fit == Fit::lagged);
  }
  EXPECT_NEAR(angle[0], angle[1], 1e-4);
}

TEST(HostSimbody, SeatsTurnWithTheirBody) {
  const auto columns = [](const Rotation& r) {
    Eigen::Matrix3d all;
    for (int i = 0; i < 9; ++i) all(i / 3, i % 3) = r[i / 3][i % 3];
    return all;
  };
  const auto rotation = [](const Eigen::Matrix3d& axes) {
    const Eigen::Quaterniond q(axes);
    return Rotation(Quaternion(q.w(), q.x(), q.y(), q.z()));
  };
  const auto vector = [](const Vec3& v) {
    return Eigen::Vector3d(v[0], v[1], v[2]);
  };
  for (const bool on_parent : {false, true}) {
    World w;
    const std::string file = cup(on_parent);
    const Body::Rigid body(MassProperties(100, Vec3(0, 0, -0.4),
                                          UnitInertia(0.2, 0.2, 0.05) * 100.0));
    MobilizedBody::Weld parent(w.matter.Ground(),
                               Transform(rotation(attitude(on_parent, true))),
                               body, Transform());
    const MobilizedBody::Ball link(parent, body);
    w.weigh(Vec3(0, 0, -9.81));
    w.friction.add(link, file);
    w.begin();
    link.setQToFitRotation(w.state,
                           rotation(attitude(on_parent, true).transpose() *
                                    attitude(on_parent, false)));
    link.setUToFitAngularVelocity(w.state, Vec3(0.3, 0.1, 0.5));
    w.friction.settle(w.state);
    w.system.realize(w.state, Stage::Acceleration);
    // Moment of the reactions to which friction fits.
    const Eigen::Vector3d rate = vector(link.getBodyAngularVelocity(w.state));
    const Eigen::Matrix3d axes =
        columns((on_parent ? MobilizedBody(parent) : MobilizedBody(link))
                    .getBodyRotation(w.state));
    const auto& solution = w.friction.hinge(0);
    const Eigen::Vector3d reaction = axes * Eigen::Vector3d(solution.reaction);
    const Eigen::Vector3d wanted = moment_in(file, axes, reaction, rate);
    EXPECT_LT(
        (axes * Eigen::Vector3d(solution.friction_moment) - wanted).norm(),
        1e-12 * wanted.norm());
    EXPECT_LT((vector(link.findMobilizerReactionOnBodyAtMInGround(w.state)[1]) -
               reaction)
                  .norm(),
              1e-6 * reaction.norm());
    EXPECT_NEAR(w.friction.power(w.state) / wanted.dot(rate), 1, 1e-7);
  }
}

/// A free bus with booms that turn about z.
void add_booms(World& w, int booms) {
  const Body::Rigid bus(MassProperties(200, Vec3(0), Inertia(35, 35, 35)));
  const Body::Rigid boom(MassProperties(5, Vec3(0), Inertia(2, 2, 3.75)));
  w.bodies.push_back(MobilizedBody::Free(w.matter.Ground(), bus));
  for (int i = 0; i < booms; ++i) {
    w.bodies.push_back(MobilizedBody::Pin(
        w.bodies[0], Transform(Vec3(i == 0 ? 0.5 : -0.5, 0, 0)), boom,
        Transform(Vec3(-1.5, 0, 0))));
    w.friction.add(w.bodies.back(), pin_file);
  }
}

double energy(const World& w) {
  w.system.realize(w.state, Stage::Dynamics);
  return w.matter.calcKineticEnergy(w.state);
}

// With the response w of the hinge's rate u to a unit impulse, u/w and a loss
// of u^2/(2 w): as of a motor of 2 N m over 90 deg, pi J, which libcontact's
// own runs and another model have too (tests/separation/stops_test.cpp).
TEST(HostSimbody, LatchesKeepMomentum) {
  World w;
  add_booms(w, 1);
  w.begin();
  constexpr double impulse = 7.488338235624;
  w.bodies[1].setOneU(w.state, 0, 2 * Pi / impulse);
  w.friction.settle(w.state);
  const double before = energy(w);
  const SpatialVec momentum =
      w.matter.calcSystemMomentumAboutGroundOrigin(w.state);
  const Vec3 given = w.friction.latch(w.state, w.bodies[1]);
  EXPECT_NEAR(-given[2], impulse, 1e-11);
  EXPECT_NEAR(before - energy(w), Pi, 1e-11);
  const SpatialVec after =
      w.matter.calcSystemMomentumAboutGroundOrigin(w.state);
  EXPECT_LT((after - momentum).norm(), 1e-12 * momentum.norm());
  EXPECT_EQ(w.bodies[1].getOneU(w.state, 0), 0);
}

// With a hinge that rests, which the impulse turns.
TEST(HostSimbody, LatchesBesideOthers) {
  World w;
  add_booms(w, 2);
  const Force::MobilityDiscreteForce motor(w.forces, w.bodies[1],
                                           MobilizerUIndex(0), 0);
  // Away from its hinge, so that friction holds it.
  const Force::ConstantForce pull(w.forces, w.bodies[2], Vec3(0),
                                  Vec3(1000, 0, 0));
  w.begin();
  w.bodies[1].setOneU(w.state, 0, 0.5);
  w.friction.settle(w.state);
  ASSERT_TRUE(w.bodies[2].isLocked(w.state));
  const double before = energy(w);
  const SpatialVec momentum =
      w.matter.calcSystemMomentumAboutGroundOrigin(w.state);
  const Vec3 impulse = w.friction.latch(w.state, w.bodies[1]);
  EXPECT_NE(w.bodies[2].getOneU(w.state, 0), 0);
  EXPECT_LT(
      (w.matter.calcSystemMomentumAboutGroundOrigin(w.state) - momentum).norm(),
      1e-12 * momentum.norm());
  EXPECT_NEAR(before - energy(w), impulse.norm() * 0.5 / 2, 1e-12 * before);
  // It holds what friction would not, 5 N m, to the last bit.
  motor.setMobilityForce(w.state, 5);
  const double angle = w.bodies[1].getOneQ(w.state, 0);
  w.run(2, 1e-8);
  EXPECT_EQ(w.bodies[1].getOneQ(w.state, 0), angle);
  EXPECT_EQ(w.friction.latch(w.state, w.bodies[1]), Vec3(0));
}

// The guide of the folding arm holds during the impulse, which leaves nothing
// that moves.
TEST(HostSimbody, LatchesInALoop) {
  World w;
  add_chain(w, 2, false, 1);
  const Constraint::PointInPlane guide(w.matter.Ground(), UnitVec3(XAxis), 0,
                                       w.bodies[1], Vec3(0, 0, -0.5));
  w.begin();
  w.bodies[0].setOneQ(w.state, 0, 0.3);
  w.bodies[1].setOneQ(w.state, 0, -0.6);
  w.system.realize(w.state, Stage::Position);
  w.system.projectQ(w.state, 1e-12);
  w.bodies[0].setOneU(w.state, 0, 0.3);
  w.system.realize(w.state, Stage::Velocity);
  w.system.projectU(w.state, 1e-12);
  w.friction.settle(w.state);
  EXPECT_GT(w.rate(), 0.1);
  w.friction.latch(w.state, w.bodies[0]);
  EXPECT_LT(w.rate(), 1e-12);
}

// A panel that others had locked came off without a word.
TEST(HostSimbody, RefusesLocksOfOthers) {
  World w;
  add_booms(w, 2);
  w.begin();
  w.bodies[1].setOneU(w.state, 0, 0.5);
  w.friction.settle(w.state);
  w.bodies[1].lock(w.state);
  const std::string message =
      "mobilized body 2 has friction and was locked by others: "
      "HingeFriction::latch() locks it";
  EXPECT_EQ(refused([&] { w.system.realize(w.state, Stage::Acceleration); }),
            message);
  EXPECT_EQ(refused([&] { w.friction.settle(w.state); }), message);
  EXPECT_EQ(refused([&] { w.friction.latch(w.state, w.bodies[0]); }),
            "HingeFriction::latch: body must be one that add() has had");
}

TEST(HostSimbody, SaysWhatIsWrong) {
  World w;
  const Body::Rigid body(MassProperties(1, Vec3(0), Inertia(1)));
  const auto refusal = [&](const MobilizedBody& b, const std::string& file) {
    return refused([&] { w.friction.add(b, file); });
  };
  EXPECT_EQ(
      refusal(MobilizedBody::Slider(w.matter.Ground(), body), pin_file),
      "HingeFriction::add: body must have a Ball, Gimbal or Pin mobilizer");
  EXPECT_EQ(
      refusal(MobilizedBody::Universal(w.matter.Ground(), body), pin_file),
      "HingeFriction::add: a Universal mobilizer must be two Pins: each of its "
      "axes is a joint with a load of its own");
  EXPECT_EQ(refusal(MobilizedBody::Pin(w.matter.Ground(), body), ball_file),
            "HingeFriction::add: " + ball_file + " must be a pin joint");
}

}  // namespace
}  // namespace contact::test::simbody_test
