// One acceleration evaluation of a carrier with L bodies: state in, all
// accelerations out, kinematics included, frictionless, gravity only. The
// column `motion` is the time for one motion.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <numbers>

#include "multibody/friction/coupled_dynamics.hpp"
#include "multibody/motion/motion.hpp"
#include "multibody_support/dense_solver.hpp"
#include "multibody_support/friction_parts.hpp"
#include "multibody_support/prepared.hpp"
#include "multibody_support/random_instant.hpp"
#ifdef CONTACT_HAS_SIMBODY
#include "simbody_system.hpp"
#endif

namespace {

using contact::InstructionSet;
using multibody::Dynamics;
using multibody::Instant;
using multibody::Prepared;
using multibody::test::Mix;

// On the carrier; each on the one before; two on each, and on the carrier.
enum class Hung { star, chain, binary };

int parent_of(int body, Hung hung) {
  return hung == Hung::star    ? -1
         : hung == Hung::chain ? body - 1
                               : body / 2 - 1;
}

Instant free_motion(Mix mix, int bodies, Hung hung = Hung::star) {
  Instant instant = random_instant(mix, bodies, 1);
  for (int i = 0; i < bodies; ++i) {
    instant.bodies[i].body.parent = parent_of(i, hung);
  }
  instant.active_force.setZero();
  instant.active_moment_com.setZero();
  for (multibody::BodyInstant& body : instant.bodies) {
    body.active_force.setZero();
    body.active_moment_com.setZero();
    body.friction_moment.setZero();
  }
  return instant;
}

Prepared prepared(benchmark::State& state, Mix mix, Hung hung = Hung::star) {
  return prepare(free_motion(mix, static_cast<int>(state.range(0)), hung));
}

// Runs f(); `motions` of them in one call.
template <class F>
void measure(benchmark::State& state, int motions, F f) {
  for (auto _ : state) {
    f();
    benchmark::ClobberMemory();
  }
  state.counters["motion"] =
      benchmark::Counter(static_cast<double>(motions),
                         benchmark::Counter::kIsIterationInvariantRate |
                             benchmark::Counter::kInvert);
}

// `body`: the time for one of them, the same for 1 as for 1024.
template <Hung hung>
void evaluate(benchmark::State& state, Mix mix, InstructionSet set) {
  const Prepared p = prepared(state, mix, hung);
  Dynamics dynamics(p.system, set);
  std::vector<multibody::Vec3<double>> accelerations(dynamics.size());
  measure(state, 1, [&] {
    dynamics.evaluate(p.state.data(), p.forces);
    dynamics.relative_accelerations(accelerations);
  });
  state.counters["body"] =
      benchmark::Counter(static_cast<double>(state.range(0)),
                         benchmark::Counter::kIsIterationInvariantRate |
                             benchmark::Counter::kInvert);
}

template <Hung hung>
void increment(benchmark::State& state, Mix mix) {
  const Prepared p = prepared(state, mix, hung);
  Dynamics dynamics = p.dynamics();
  dynamics.evaluate(p.state.data(), p.forces);
  const std::vector<multibody::Vec3<double>> change(dynamics.size(),
                                                    {1e-3, 2e-3, -1e-3});
  std::vector<multibody::Vec3<double>> accelerations(dynamics.size());
  measure(state, 1, [&] {
    dynamics.add_friction(change);
    dynamics.relative_accelerations(accelerations);
  });
}

void reactions(benchmark::State& state, Mix mix) {
  const Prepared p = prepared(state, mix);
  Dynamics dynamics = p.dynamics();
  dynamics.evaluate(p.state.data(), p.forces);
  std::vector<multibody::Reaction<double>> to(dynamics.size());
  measure(state, 1, [&] { dynamics.reactions(to); });
}

void dense_cholesky(benchmark::State& state, Mix mix) {
  const Prepared p = prepared(state, mix);
  multibody::test::DenseSolver dense(p.system);
  measure(state, 1, [&] { dense.evaluate(p.state.data(), p.forces); });
}

// A stretch of a run with friction: states half a step of 1 ms apart, as the
// stages of the paper's Runge-Kutta steps see them, forth and back.
enum class AxisHinge { node, pin };
struct Stretch {
  Stretch(Mix mix, int bodies, AxisHinge axis_hinge = AxisHinge::node,
          Hung hung = Hung::star)
      : instant(free_motion(mix, bodies, hung)), prepared(prepare(instant)) {
    const contact::FrictionLaw law(0.1, 1e5);
    multibody::MotionStart start;
    start.carrier = {instant.position, instant.velocity, instant.rotation,
                     instant.rotation * instant.angular_velocity};
    for (const multibody::BodyInstant& body : instant.bodies) {
      const bool on_axis = body.body.kind == multibody::HingeKind::axis;
      if (on_axis && axis_hinge == AxisHinge::node) {
        friction.emplace_back(
            multibody::GroupFriction{multibody::test::ball_and_pin(law, 0.2)});
      } else if (on_axis) {
        friction.emplace_back(
            multibody::JointFriction{multibody::test::pin_joint(law, 0.02)});
      } else {
        friction.emplace_back(
            multibody::JointFriction{multibody::test::ball_joint(law, 0.01)});
      }
      multibody::BodyStart& to = start.bodies.emplace_back();
      to.rotation = body.rotation;
      to.relative_angular_velocity = body.relative_angular_velocity;
      to.angle = body.angle;
      to.angle_rate = body.angle_rate;
    }
    multibody::MotionOptions options;
    options.gravity = instant.gravity;
    options.integrator = multibody::Integrator::rk4;
    options.step = 1e-3;
    multibody::Motion motion(prepared.system, friction, nullptr, start,
                             options);
    for (int i = 0; i < 64; ++i) {
      motion.advance_to(0.5e-3 * i);
      states.push_back(motion.save().numbers);
    }
    for (int i = 62; i > 0; --i) states.push_back(std::vector(states[i]));
  }

  const double* next() {
    at = (at + 1) % states.size();
    return states[at].data();
  }

  Instant instant;
  Prepared prepared;
  std::vector<multibody::HingeFriction> friction;
  std::vector<std::vector<double>> states;
  std::size_t at = 0;
};

// Friction converged at every evaluation, rates of the state included.
template <AxisHinge axis_hinge, Hung hung = Hung::star>
void with_friction(benchmark::State& state, Mix mix, InstructionSet set) {
  Stretch run(mix, static_cast<int>(state.range(0)), axis_hinge, hung);
  const contact::detail::WithInstructionSet with(set);
  const multibody::CoupledDynamics coupled(run.prepared.system, run.friction);
  multibody::FrictionMemory memory = coupled.beginning();
  multibody::Evaluation found(run.prepared.system);
  found.forces = run.prepared.forces;
  for (int i = 0; i < coupled.size(); ++i) {
    const double* s = run.next() + coupled.layout().offset(i);
    if (mix == Mix::axes) {
      memory.hinges[i].direction.z() = s[1] > 0 ? 1 : -1;
    }
  }
  std::vector<double> rates(run.states[0].size());
  double evaluations = 0, iterations = 0;
  measure(state, 1, [&] {
    const double* s = run.next();
    iterations += coupled.evaluate(s, memory, found).iterations;
    evaluations += 1;
    found.dynamics.rates(s, {}, rates.data());
  });
  state.counters["outer"] = iterations / evaluations;
}

template <Hung hung>
void without_friction(benchmark::State& state, Mix mix, InstructionSet set) {
  Stretch run(mix, static_cast<int>(state.range(0)),
              hung == Hung::star ? AxisHinge::node : AxisHinge::pin, hung);
  Dynamics dynamics(run.prepared.system, set);
  std::vector<double> rates(run.states[0].size());
  measure(state, 1, [&] {
    const double* s = run.next();
    dynamics.evaluate(s, run.prepared.forces);
    dynamics.rates(s, {}, rates.data());
  });
}

// The same bodies without hinges.
void unhinged(benchmark::State& state, Mix mix) {
  Stretch run(mix, static_cast<int>(state.range(0)));
  Dynamics dynamics(run.prepared.system);
  for (int i = 0; i < dynamics.size(); ++i) {
    dynamics.set_mode(i, multibody::JointMode::released);
  }
  std::vector<double> s(dynamics.layout().size(), 0.1), rates(s.size());
  measure(state, 1, [&] {
    dynamics.evaluate(s.data(), run.prepared.forces);
    dynamics.rates(s.data(), {}, rates.data());
  });
}

#ifdef CONTACT_HAS_SIMBODY
// Difference of the carrier's accelerations, to which all bodies contribute.
double difference(const Instant& instant,
                  const multibody::bench::SimbodySystem& system) {
  const multibody::InstantResult ours = multibody::evaluate(instant);
  return (ours.acceleration - system.carrier_acceleration()).norm() /
             ours.acceleration.norm() +
         (ours.angular_acceleration - system.carrier_angular_acceleration())
                 .norm() /
             ours.angular_acceleration.norm();
}

template <Hung hung>
void simbody(benchmark::State& state, Mix mix) {
  const Instant instant =
      free_motion(mix, static_cast<int>(state.range(0)), hung);
  multibody::bench::SimbodySystem system(instant);
  measure(state, 1, [&] { system.evaluate(); });
  state.counters["difference"] = difference(instant, system);
}

// Both by turns, and the least time of each, ns: other load on the machine
// comes and goes. All accelerations; then the reactions as well.
template <Hung hung>
void beside_simbody(benchmark::State& state, Mix mix) {
  const Instant instant =
      free_motion(mix, static_cast<int>(state.range(0)), hung);
  const Prepared p = prepare(instant);
  Dynamics dynamics(p.system);
  std::vector<multibody::Vec3<double>> accelerations(dynamics.size());
  std::vector<multibody::Reaction<double>> reactions(dynamics.size());
  multibody::bench::SimbodySystem system(instant);
  using Clock = std::chrono::steady_clock;
  const auto time = [](double& least, int times, auto f) {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < times; ++i) f();
    const std::chrono::duration<double, std::nano> took = Clock::now() - start;
    least = std::min(least, took.count() / times);
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double ours[] = {infinity, infinity};
  double theirs[] = {infinity, infinity};
  for (auto _ : state) {
    for (const bool react : {false, true}) {
      time(ours[react], 10, [&] {
        dynamics.evaluate(p.state.data(), p.forces);
        dynamics.relative_accelerations(accelerations);
        if (react) dynamics.reactions(reactions);
      });
      time(theirs[react], 1, [&] {
        system.evaluate();
        if (react) system.find_reactions();
      });
    }
  }
  state.counters["ours"] = ours[0];
  state.counters["simbody"] = theirs[0];
  state.counters["ratio"] = theirs[0] / ours[0];
  state.counters["ratio_with_reactions"] = theirs[1] / ours[1];
  state.counters["difference"] = difference(instant, system);
}
#endif

// A core with four boosters that turn about ball joints at their upper ends:
// masses and sizes as in a large launcher just before separation.
Instant launcher() {
  using Eigen::Matrix3d;
  using Eigen::Vector3d;
  Instant instant;
  instant.carrier = {60000, Matrix3d::Zero()};
  instant.carrier.inertia.diagonal() << 2.5e6, 2.5e6, 6e4;
  instant.gravity = Vector3d(0, 0, -9.5);
  instant.velocity = Vector3d(300, 0, 1500);
  instant.angular_velocity = Vector3d(0.01, -0.02, 0.005);
  for (int i = 0; i < 4; ++i) {
    multibody::BodyInstant body;
    const Matrix3d turn =
        Eigen::AngleAxisd(i * std::numbers::pi / 2, Vector3d::UnitZ())
            .toRotationMatrix();
    body.body = {multibody::HingeKind::ball, 5000, Matrix3d::Zero()};
    body.body.inertia.diagonal() << 1.2e5, 1.2e5, 6e3;
    body.body.hinge_from_com = Vector3d(-0.5, 0, 9);
    body.body.hinge_from_carrier_com = turn * Vector3d(1.3, 0, 4);
    body.rotation = turn;
    body.relative_angular_velocity = Vector3d(0.02 * i, -0.15, 0.03);
    instant.bodies.push_back(body);
  }
  return instant;
}

multibody::Motion motion_of(
    const Instant& instant, double tolerance,
    std::vector<multibody::HingeFriction> friction = {}) {
  multibody::MotionStart start;
  start.carrier = {instant.position, instant.velocity, instant.rotation,
                   instant.rotation * instant.angular_velocity};
  std::vector<multibody::Body> bodies;
  for (const multibody::BodyInstant& body : instant.bodies) {
    bodies.push_back(body.body);
    multibody::BodyStart& to = start.bodies.emplace_back();
    to.rotation = body.rotation;
    to.relative_angular_velocity = body.relative_angular_velocity;
  }
  multibody::MotionOptions options;
  options.gravity = instant.gravity;
  options.relative_tolerance = options.absolute_tolerance = tolerance;
  return {multibody::System(instant.carrier, bodies), std::move(friction),
          nullptr, start, options};
}

constexpr double flight = 10;  // s

void our_flight(benchmark::State& state) {
  const Instant instant = launcher();
  for (auto _ : state) {
    multibody::Motion motion = motion_of(instant, 1e-11);
    motion.advance_to(flight);
    benchmark::DoNotOptimize(motion.sample().motions());
  }
}

// With friction, at the tolerances that motions have unless told otherwise.
void our_flight_with_friction(benchmark::State& state) {
  const Instant instant = launcher();
  const std::vector<multibody::HingeFriction> friction(
      4, multibody::JointFriction{multibody::test::ball_joint(
             contact::FrictionLaw(0.15, 1e5), 0.05)});
  multibody::MotionCounts counts;
  double hinge_changes = 0;
  for (auto _ : state) {
    multibody::Motion motion = motion_of(instant, 1e-9, friction);
    motion.advance_to(flight);
    counts = motion.counts();
    hinge_changes = static_cast<double>(motion.changes().size());
  }
  state.counters["evaluations"] = static_cast<double>(counts.evaluations);
  state.counters["changes"] = hinge_changes;
}

#ifdef CONTACT_HAS_SIMBODY
// `difference`: largest distance between the two programs' centres of mass,
// m, after 10 s in which they have gone some 15 km.
void simbody_flight(benchmark::State& state) {
  const Instant instant = launcher();
  std::vector<Eigen::Vector3d> theirs;
  for (auto _ : state) {
    multibody::bench::SimbodySystem system(instant);
    system.advance(flight, 1e-11);
    theirs = system.positions();
  }
  multibody::Motion motion = motion_of(instant, 1e-13);
  motion.advance_to(flight);
  double difference = 0;
  double moved = 0;
  for (std::size_t i = 0; i < theirs.size(); ++i) {
    const Eigen::Vector3d ours = motion.sample().motions()[i].position;
    difference = std::max(difference, (ours - theirs[i]).norm());
    moved = std::max(moved, ours.norm());
  }
  state.counters["difference"] = difference;
  state.counters["relative"] = difference / moved;
}
#endif

void register_all(const std::string& name, Mix mix) {
  const auto add = [&](const std::string& method, auto function, int most) {
    auto* b = benchmark::RegisterBenchmark(
        (name + "/" + method).c_str(),
        [=](benchmark::State& state) { function(state, mix); });
    for (const int bodies : {1, 2, 4, 8, 16, 64, 256, 1024}) {
      if (bodies <= most) b->Arg(bodies);
    }
  };
  for (const InstructionSet set :
       {InstructionSet::baseline, InstructionSet::avx2,
        InstructionSet::avx512}) {
    if (!contact::is_supported(set)) continue;
    const auto add_for_set = [&](const char* method, auto function, int most) {
      add(
          std::string(method) + '/' + contact::name(set),
          [=](auto& state, Mix m) { function(state, m, set); }, most);
    };
    add_for_set("two_step", evaluate<Hung::star>, 1024);
    add_for_set("without_friction", without_friction<Hung::star>, 64);
    add_for_set("with_friction", with_friction<AxisHinge::node>, 64);
    if (mix == Mix::axes) {
      add_for_set("with_pin_friction", with_friction<AxisHinge::pin>, 64);
    }
  }
  const auto widest = [&](const char* method, auto function, int most) {
    add(
        method,
        [=](auto& state, Mix m) {
          function(state, m, contact::instruction_set());
        },
        most);
  };
  widest("chain/two_step", evaluate<Hung::chain>, 1024);
  widest("binary/two_step", evaluate<Hung::binary>, 1024);
  add("chain/increment", increment<Hung::chain>, 256);
  widest("chain/with_pin_friction", with_friction<AxisHinge::pin, Hung::chain>,
         16);
  widest("chain/without_friction", without_friction<Hung::chain>, 16);
  add("increment", increment<Hung::star>, 256);
  add("reactions", reactions, 256);
  add("unhinged", unhinged, 64);
  add("dense_cholesky", dense_cholesky, 64);
#ifdef CONTACT_HAS_SIMBODY
  add("simbody", simbody<Hung::star>, 256);
  add("chain/simbody", simbody<Hung::chain>, 64);
  add("chain/beside_simbody", beside_simbody<Hung::chain>, 64);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  register_all("balls", Mix::balls);
  register_all("axes", Mix::axes);
  benchmark::RegisterBenchmark("flight/ours", our_flight);
  benchmark::RegisterBenchmark("flight/ours_with_friction",
                               our_flight_with_friction);
#ifdef CONTACT_HAS_SIMBODY
  benchmark::RegisterBenchmark("flight/simbody", simbody_flight);
#endif
  benchmark::RunSpecifiedBenchmarks();
}
