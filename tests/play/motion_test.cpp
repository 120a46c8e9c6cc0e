#include <arkode/arkode_erkstep.h>
#include <gtest/gtest.h>
#include <nvector/nvector_serial.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "libcontact/play/impact.hpp"
#include "libcontact/play/play_joint.hpp"
#include "play/reference_joint.hpp"
#include "support/accuracy_report.hpp"
#include "support/numbers.hpp"

// Motions of joints with play, integrated on the library's force law with touch
// and parting as events, against those that another program has integrated.
namespace contact::test::motion_test {
namespace {

using Eigen::Vector3d;
using State = std::vector<double>;

// A motion with one contact.
struct Problem {
  std::function<void(double time, const State&, State& rates)> rates;
  // delta and d delta/dt: the event and its rate.
  std::function<std::pair<double, double>(double time, const State&)> event;
  State size;  // scales of the components, for tolerances
};

// Explicit Runge-Kutta steps by ARKODE. An event is met exactly: the
// step is made again up to its time, which Newton's method corrects.
class Integration {
 public:
  Integration(Problem problem, State start)
      : problem_(std::move(problem)), state_(std::move(start)) {
    SUNContext_Create(nullptr, &context_);
    const auto n = static_cast<sunindextype>(state_.size());
    vector_ = N_VMake_Serial(n, state_.data(), context_);
    allowed_ = N_VNew_Serial(n, context_);
    for (std::size_t i = 0; i < state_.size(); ++i) {
      NV_Ith_S(allowed_, static_cast<sunindextype>(i)) =
          tolerance * problem_.size[i];
    }
    memory_ = ERKStepCreate(rate, 0, vector_, context_);
    ERKStepSetUserData(memory_, this);
    ERKStepSVtolerances(memory_, tolerance, allowed_);
    ERKStepSetTableNum(memory_, ARKODE_DORMAND_PRINCE_7_4_5);
    ERKStepSetMaxNumSteps(memory_, -1);
    // A twentieth of the shortest contact; no flight jumps over one.
    ERKStepSetMaxStep(memory_, 1e-6);
  }
  ~Integration() {
    ERKStepFree(&memory_);
    N_VDestroy(allowed_);
    N_VDestroy(vector_);
    SUNContext_Free(&context_);
  }
  Integration(const Integration&) = delete;
  Integration& operator=(const Integration&) = delete;

  // True at an event, which is `time()`; false at the end.
  bool advance_to(double end) {
    while (time_ < end) {
      const double before = time_;
      const State begin = state_;
      const bool inside = is_inside_;
      step(end);
      if ((event().first > 0) == inside) continue;
      // Newton from the step's end, each time from its beginning.
      for (int i = 0; i < 8; ++i) {
        const auto [delta, rate] = event();
        const double correction = -delta / rate;
        const double at = time_ + correction;
        if (std::abs(correction) < 1e-18 || !(at > before)) break;
        restart(before, begin);
        while (time_ < at) step(at);
      }
      is_inside_ = !inside;
      restart(time_, State(state_));
      return true;
    }
    return false;
  }

  double time() const { return time_; }
  const State& state() const { return state_; }
  bool is_inside() const { return is_inside_; }

 private:
  static constexpr double tolerance = 2e-14;

  std::pair<double, double> event() const {
    return problem_.event(time_, state_);
  }
  void restart(double time, const State& from) {
    state_ = from;
    time_ = time;
    ERKStepReInit(memory_, rate, time, vector_);
    ERKStepSetInitStep(memory_, 1e-9);
  }
  void step(double limit) {
    ERKStepSetStopTime(memory_, limit);
    ASSERT_GE(ERKStepEvolve(memory_, limit, vector_, &time_, ARK_ONE_STEP), 0);
  }
  static int rate(realtype time, N_Vector state, N_Vector to, void* self) {
    auto* of = static_cast<Integration*>(self);
    const double* y = N_VGetArrayPointer(state);
    const State now(y, y + of->state_.size());
    State rates(now.size());
    of->problem_.rates(time, now, rates);
    std::ranges::copy(rates, N_VGetArrayPointer(to));
    return 0;
  }

  Problem problem_;
  State state_;
  bool is_inside_ = false;
  double time_ = 0;
  SUNContext context_ = nullptr;
  N_Vector vector_ = nullptr;
  N_Vector allowed_ = nullptr;
  void* memory_ = nullptr;
};

double damping_of(double restitution, double speed) {
  return HuntCrossley::from_restitution(restitution, speed).damping();
}

// One mass that flies against its seat: restitution, times and penetration
// equal the closed forms.
TEST(PlayMotion, ImpactIsThatOfTheClosedForms) {
  for (const JointSpec& spec :
       {test::steel_ball(), test::slider_crank_joint()}) {
    const double mass = 0.064;
    const double speed = 0.4;
    const auto damping = HuntCrossley::from_restitution(0.6, 0.3);
    const PlayJoint joint(spec, {damping});
    const double eps = spec.geometry.radial_clearance();
    const auto motion = [](const State& y) -> PlayMotion {
      return {{y[0], 0, 0}, {y[1], 0, 0}, {0, 0, 0}};
    };
    Integration run({[&](double, const State& y, State& rates) {
                       rates = {y[1], joint(motion(y)).force.x() / mass};
                     },
                     [&](double, const State& y) {
                       return std::pair(joint.penetration(motion(y)), y[1]);
                     },
                     {1e-5, 1}},
                    {eps - 1e-6, speed});
    ASSERT_TRUE(run.advance_to(1e-3));
    const double touch = run.time();
    EXPECT_NEAR(touch, 1e-6 / speed, 1e-17);
    ASSERT_TRUE(run.advance_to(1e-3));
    const Impact impact = JointImpact(spec)(damping, mass, speed);
    // Many steps of 2e-14 each; 1e-12 to 2e-11 seen, by the force's last bits.
    EXPECT_NEAR(-run.state()[1] / speed, impact.restitution, 1e-10);
    EXPECT_NEAR((run.time() - touch) / impact.duration(), 1, 1e-9);
  }
}

// Rows of a trajectory against the reference's; the error of a column over the
// largest of it.
class Trajectory {
 public:
  Trajectory(const char* file, std::vector<std::string> columns, double budget)
      : table_(file),
        columns_(std::move(columns)),
        largest_(columns_.size()),
        report_("trajectory", budget) {
    for (const ReferenceTable::Row row : table_) {
      for (std::size_t i = 0; i < columns_.size(); ++i) {
        largest_[i] = std::max(largest_[i], std::abs(row.value(columns_[i])));
      }
    }
  }
  const ReferenceTable& table() const { return table_; }
  void compare(const ReferenceTable::Row& row, std::span<const double> values) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      report_.add_error(
          std::abs(values[i] - row.value(columns_[i])) / largest_[i],
          columns_[i] + ", " + row.label());
    }
  }
  void check() { report_.check(); }

 private:
  ReferenceTable table_;
  std::vector<std::string> columns_;
  std::vector<double> largest_;
  AccuracyReport report_;
};

// Runs through the rows of the trajectory; the number of events.
template <class Values>
int follow(Integration& run, Trajectory& trajectory, const Values& values) {
  int events = 0;
  for (const ReferenceTable::Row row : trajectory.table()) {
    while (run.advance_to(row.value("time_s"))) ++events;
    trajectory.compare(row, values(run.time(), run.state()));
  }
  trajectory.check();
  return events;
}

// Crank at constant speed, rod and slider, whose journal has play in the eye of
// the rod: data/reference/play/README.md. State: angle and rate of the rod,
// place and velocity of the slider, energy lost, work of the crank.
struct SliderCrank {
  static constexpr double crank = 0.05;
  static constexpr double rod = 0.12;
  static constexpr double rod_mass = 0.21;
  static constexpr double rod_inertia = 2.5e-4;
  static constexpr double slider_mass = 0.14;
  static constexpr double speed = 5000 * 2 * pi / 60;

  PlayJoint joint{test::slider_crank_joint(),
                  {HuntCrossley(damping_of(0.9, 1))}};
  // The penetration below which the force is a power of it; 0: the law's own.
  double tail = 0;

  // The joint's answer with that tail, which keeps force and energy there.
  PlayForce force(const PlayMotion& motion) const {
    PlayForce f = joint(motion);
    if (!(f.penetration > 0 && f.penetration < tail)) return f;
    const ForceState end = joint.force_law().at(tail);
    const double power = end.force * tail / end.energy - 1;
    const double force = end.force * std::pow(f.penetration / tail, power);
    const double share = force / joint.force_law().force(f.penetration);
    f.force *= share;
    f.damping_power *= share;
    f.energy = force * f.penetration / (power + 1);
    return f;
  }

  PlayMotion motion(double time, const State& y) const {
    const Vector3d at(std::cos(speed * time), std::sin(speed * time), 0);
    const Vector3d across(-at.y(), at.x(), 0);
    const Vector3d along(std::cos(y[0]), std::sin(y[0]), 0);
    const Vector3d normal(-along.y(), along.x(), 0);
    return {Vector3d(y[2], 0, 0) - crank * at - rod * along,
            Vector3d(y[3], 0, 0) - crank * speed * across - rod * y[1] * normal,
            {0, 0, -y[1]}};
  }
  void rates(double time, const State& y, State& rates) const {
    const PlayForce f = force(motion(time, y));
    const Vector3d at(std::cos(speed * time), std::sin(speed * time), 0);
    const Vector3d across(-at.y(), at.x(), 0);
    const Vector3d along(std::cos(y[0]), std::sin(y[0]), 0);
    const Vector3d normal(-along.y(), along.x(), 0);
    const Vector3d pin = -crank * speed * speed * at;  // its acceleration
    const double inertia = rod_inertia + rod_mass * rod * rod / 4;
    const double turn = (-rod_mass * rod / 2 * normal.dot(pin) -
                         rod * along.cross(f.force).z()) /
                        inertia;
    // Reaction of the crank's pin on the rod.
    const Vector3d middle =
        pin + rod / 2 * (turn * normal - y[1] * y[1] * along);
    const Vector3d reaction = rod_mass * middle + f.force;
    rates = {y[1],
             turn,
             y[3],
             f.force.x() / slider_mass,
             -f.damping_power - f.friction_power,
             reaction.dot(crank * speed * across)};
  }
  double energy(double time, const State& y) const {
    const Vector3d across(-std::sin(speed * time), std::cos(speed * time), 0);
    const Vector3d normal(-std::sin(y[0]), std::cos(y[0]), 0);
    const Vector3d middle = crank * speed * across + rod / 2 * y[1] * normal;
    return rod_mass / 2 * middle.squaredNorm() + rod_inertia / 2 * y[1] * y[1] +
           slider_mass / 2 * y[3] * y[3] + joint(motion(time, y)).energy +
           y[4] - y[5];
  }
};

void expect_slider_crank(const SliderCrank& of, double budget) {
  const double rate =
      -SliderCrank::speed * SliderCrank::crank / SliderCrank::rod;
  const State start = {0, rate, 0.17, 0, 0, 0};
  Integration run(
      {[&](double t, const State& y, State& r) { of.rates(t, y, r); },
       [&](double t, const State& y) {
         const PlayMotion m = of.motion(t, y);
         return std::pair(of.joint.penetration(m),
                          of.joint.penetration_rate(m));
       },
       {1, 500, 0.1, 30, 1, 100}},
      start);
  Trajectory trajectory("play/slider_crank.csv",
                        {"rod_angle_rad", "slider_x_m", "rod_rate_rad_per_s",
                         "slider_velocity_m_per_s", "dissipated_J"},
                        budget);
  const double before = of.energy(0, start);
  double worst = 0;
  const int events = follow(run, trajectory, [&](double t, const State& y) {
    worst = std::max(worst, std::abs(of.energy(t, y) - before));
    return State{y[0], y[2], y[1], y[3], y[4]};
  });
  EXPECT_EQ(events, 71);
  // Some 10,000 steps of 2e-14.
  std::printf("energy balance %.1e of %.1f J\n", worst, before);
  EXPECT_LT(worst, 1e-11 * before);
}

// The reference's law is a power below 0.008 rad, ours below 0.003 rad: that
// moves a touch by 1e-12 s, which 36 impacts enlarge a million times.
TEST(PlayMotion, SliderCrankIsTheReference) {
  SliderCrank of;
  expect_slider_crank(of, 2e-6);
  const ForceLaw& law = of.joint.force_law();
  double low = law.smallest_penetration();
  double high = 1e-6;
  while (high - low > 1e-16 * high) {
    of.tail = (low + high) / 2;
    if (of.tail == low || of.tail == high) break;
    (law.half_angle(of.tail) < 0.008 ? low : high) = of.tail;
  }
  expect_slider_crank(of, 1e-8);
}

// A loose pin that falls in a ring and spins. State: place, angle, velocity,
// spin, energy lost.
struct Disc {
  static constexpr double mass = 0.0490088;
  static constexpr double inertia = 2.45044e-6;
  static constexpr double gravity = 9.81;

  static JointSpec spec() {
    const Material steel = {207e9, 0.3};
    return {.geometry = JointGeometry::pin(0.01, 1e-4, 0.02),
            .inner = steel,
            .outer = {{{0.01, steel}}, Backing::held()},
            .friction = FrictionLaw(0.15)};
  }
  PlayJoint joint{spec(), {HuntCrossley(damping_of(0.5, 0.3)), 0.02}};

  static PlayMotion motion(const State& y) {
    return {{y[0], y[1], 0}, {y[3], y[4], 0}, {0, 0, y[5]}};
  }
  void rates(const State& y, State& rates) const {
    const PlayForce f = joint(motion(y));
    rates = {y[3],
             y[4],
             y[5],
             f.force.x() / mass,
             f.force.y() / mass - gravity,
             f.moment.z() / inertia,
             -f.damping_power - f.friction_power};
  }
  double energy(const State& y) const {
    return mass / 2 * (y[3] * y[3] + y[4] * y[4]) + inertia / 2 * y[5] * y[5] +
           mass * gravity * y[1] + joint(motion(y)).energy + y[6];
  }
};

TEST(PlayMotion, LooseDiscIsTheReference) {
  const Disc of;
  const State start = {0, 0, 0, 0.3, 0.1, 200, 0};
  Integration run({[&](double, const State& y, State& r) { of.rates(y, r); },
                   [&](double, const State& y) {
                     const PlayMotion m = Disc::motion(y);
                     return std::pair(of.joint.penetration(m),
                                      of.joint.penetration_rate(m));
                   },
                   {1e-4, 1e-4, 0.1, 0.1, 0.1, 100, 0.01}},
                  start);
  Trajectory trajectory("play/disc.csv",
                        {"x_m", "y_m", "angle_rad", "vx_m_per_s", "vy_m_per_s",
                         "spin_rad_per_s", "dissipated_J"},
                        1e-8);
  const double before = of.energy(start);
  double worst = 0;
  const int events = follow(run, trajectory, [&](double, const State& y) {
    worst = std::max(worst, std::abs(of.energy(y) - before));
    return y;
  });
  EXPECT_EQ(events, 13);
  std::printf("energy balance %.1e of %.3f J\n", worst, before);
  EXPECT_LT(worst, 1e-11 * before);
}

// A pin that does not turn lies on its seat under its weight, pushed sideways
// by half of the friction force.
struct Seated {
  Disc disc;
  double weight = Disc::mass * Disc::gravity;
  double push = 0.5 * 0.15 * weight;
  State start() const {
    const double delta = disc.joint.force_law().penetration_of_force(weight);
    return {0, -1e-4 - delta, 0, 0};
  }
  PlayMotion motion(const State& y) const {
    return {{y[0], y[1], 0}, {y[2], y[3], 0}, {0, 0, 0}};
  }
};

// Friction as a set, T in [-f0 F, f0 F]: an implicit step takes the one that
// brings the slip nearest to 0.
TEST(PlayMotion, ASetOfFrictionHoldsForGood) {
  const Seated of;
  const PlayJoint joint = of.disc.joint;
  State y = of.start();
  const State start = y;
  const double h = 1e-6;
  for (int i = 0; i < 20000; ++i) {
    const PlayMotion motion = of.motion(y);
    const Vector3d n = motion.position.normalized();
    const Vector3d t(-n.y(), n.x(), 0);
    const double bound = joint.friction_bounds(motion).force;
    const Vector3d rest =
        Vector3d(of.push, -of.weight, 0) -
        joint.force_law().force(joint.penetration(motion)) * n;
    const double free = t.dot(motion.velocity) + h * t.dot(rest) / Disc::mass;
    const double friction = std::clamp(-free * Disc::mass / h, -bound, bound);
    const Vector3d change = h / Disc::mass * (rest + friction * t);
    y[2] += change.x();
    y[3] += change.y();
    y[0] += h * y[2];
    y[1] += h * y[3];
  }
  EXPECT_LT(std::abs(y[0] - start[0]), 1e-17);
  EXPECT_LT(std::abs(y[1] - start[1]), 1e-17);
}

// v = vs s/sqrt(1 - s^2), s = T/(f0 F), the sheet's vs s for small ones.
TEST(PlayMotion, RegularisedFrictionCreeps) {
  const Seated of;
  const double vs = 1e-5;
  const PlayJoint joint(Disc::spec(), {of.disc.joint.damping(), vs});
  Integration run({[&](double, const State& y, State& rates) {
                     const PlayForce f = joint(of.motion(y));
                     rates = {y[2], y[3], (f.force.x() + of.push) / Disc::mass,
                              (f.force.y() - of.weight) / Disc::mass};
                   },
                   [&](double, const State& y) {
                     const PlayMotion m = of.motion(y);
                     return std::pair(joint.penetration(m),
                                      joint.penetration_rate(m));
                   },
                   {1e-4, 1e-4, 1e-5, 1e-5}},
                  of.start());
  run.advance_to(0);
  while (run.advance_to(2e-3)) {
  }
  const double v = run.state()[2];
  EXPECT_NEAR(v / (vs * 0.5 / std::sqrt(0.75)), 1, 2e-2);
  EXPECT_GT(run.state()[0], 1e-8);
}

}  // namespace
}  // namespace contact::test::motion_test
