#include "hosts/simbody/hinge_friction.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hosts/simbody/moment_fit.hpp"

namespace contact_hosts::simbody {
namespace {

using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::Stage;
using SimTK::State;
using SimTK::Vec3;

void put(double (&to)[3], const Vec3& from) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}
Vec3 vec(const double (&from)[3]) { return {from[0], from[1], from[2]}; }

// State of a hinge. Vectors are in Ground, except the direction.
struct Hinge {
  MobilizedBody body;
  bool is_ball;
  JointHandle joint;
  bool can_rest;
  Seat seat;
  Vec3 way{0};  // unit direction of (impending) slip, parent axes
  Vec3 reaction{0};
  Vec3 moment{0};
  bool slides = false;
  Rotation from_seat{};  // at the slip
  contact_slip slip{};   // seat axes, as the next
  contact_solution solution{};
  contact_rest rest{};

  // Rotates from the axes of the half with the seat to Ground.
  Rotation axes_of_seat(const State& s) const {
    if (seat == Seat::none) return {};
    return (seat == Seat::on_body ? body : body.getParentMobilizedBody())
        .getBodyRotation(s);
  }
  Rotation axes(const State& s) const {
    return body.getParentMobilizedBody().getBodyRotation(s) *
           body.getInboardFrame(s).R();
  }
  Vec3 rate(const State& s) const {
    return body.getBodyAngularVelocity(s) -
           body.getParentMobilizedBody().getBodyAngularVelocity(s);
  }
  Vec3 direction(const State& s) const {
    return body.getParentMobilizedBody().getBodyRotation(s) * way;
  }
  void go_along(const State& s, const Vec3& v) {
    way = 0;
    if (v.norm() > 0) {
      way = ~body.getParentMobilizedBody().getBodyRotation(s) * (v / v.norm());
    }
  }
  Vec3 acceleration(const State& s) const {
    return body.getBodyAngularAcceleration(s) -
           body.getParentMobilizedBody().getBodyAngularAcceleration(s);
  }
  Vec3 axis(const State& s) const {
    return is_ball ? Vec3(0) : Vec3(axes(s) * Vec3(0, 0, 1));
  }
  // Angular velocities of a ball for one of each of its coordinates.
  SimTK::Mat33 turns(const State& s) const {
    SimTK::Mat33 all;
    for (int i = 0; i < 3; ++i) {
      all(i) = body.getHCol(s, SimTK::MobilizerUIndex(i))[0];
    }
    constexpr double least = 1e-3;  // cos of a Gimbal's second angle
    if (std::abs(det(all)) < least) {
      throw std::runtime_error(
          "a Gimbal mobilizer with friction must not come to gimbal lock: use "
          "a Ball");
    }
    return all;
  }
  // The moment that does the same work in the mobilizer's coordinates as
  // `forces`.
  Vec3 moment_of(const State& s, const SimTK::Vector& forces) const {
    if (!is_ball) {
      return body.getOneFromUPartition(s, 0, forces) * axis(s);
    }
    Vec3 own;
    for (int i = 0; i < 3; ++i) {
      own[i] = body.getOneFromUPartition(s, i, forces);
    }
    return turns(s).transpose().invert() * own;
  }
  // Converts a rate to the mobilizer's coordinates.
  SimTK::Vector rates(const State& s, const Vec3& rate) const {
    return is_ball ? SimTK::Vector(turns(s).invert() * rate)
                   : SimTK::Vector(1, dot(rate, axis(s)));
  }
};

}  // namespace

class HingeFriction::Friction : public SimTK::Force::Custom::Implementation {
 public:
  Friction(const SimTK::MultibodySystem& system,
           const SimTK::GeneralForceSubsystem& forces, const Options& options)
      : system_(system),
        forces_(forces),
        options_(options),
        fit_(options.tolerance) {}

  void realizeTopology(State& state) const override {
    cache_ = forces_.allocateCacheEntry(state, Stage::Dynamics,
                                        new SimTK::Value<Moments>());
    holds_ = forces_.allocateDiscreteVariable(
        state, Stage::Instance,
        new SimTK::Value<Holds>(Holds(unsigned(hinges.size()), Hold::none)));
    is_last_ = true;
    SimTK::SubsystemIndex i = forces_.getMySubsystemIndex();
    while (++i < system_.getNumSubsystems()) {
      if (SimTK::ForceSubsystem::isInstanceOf(system_.getSubsystem(i))) {
        is_last_ = false;
      }
    }
  }
  // Moments are added once all other forces of the subsystem are known.
  void calcForce(const State&, SimTK::Vector_<SimTK::SpatialVec>&,
                 SimTK::Vector_<Vec3>&, SimTK::Vector&) const override {}
  void realizeDynamics(const State& state) const override {
    SimTK::Vector_<SimTK::SpatialVec>& forces =
        system_.updRigidBodyForces(state, Stage::Dynamics);
    if (is_given_) return apply(forces);
    if (!aim(state)) {
      // All are locked.
    } else if (options_.fit == Fit::lagged) {
      slide();
    } else if (is_last_ && state.getNMultipliers() == 0) {
      converge_tree(state, forces);
    } else {
      converge(state);
    }
    apply(forces);
    Moments& moments = SimTK::Value<Moments>::updDowncast(
        forces_.updCacheEntry(state, cache_));
    moments.clear();
    for (const Hinge& h : hinges) moments.push_back(h.moment);
  }
  const SimTK::Array_<Vec3>& moments(const State& state) const {
    return SimTK::Value<Moments>::downcast(
        forces_.getCacheEntry(state, cache_));
  }
  double calcPotentialEnergy(const State&) const override { return 0; }

  void note_reactions(const State& state) const {
    for (Hinge& h : hinges) {
      h.reaction = h.body.findMobilizerReactionOnBodyAtMInGround(state)[1];
    }
  }
  // Prepares the next evaluation.
  void realizeAcceleration(const State& state) const override {
    if (options_.fit == Fit::lagged) note_reactions(state);
  }

  // Distance of a locked hinge from its limit; above 0 the hinge is released.
  double excess(const State& state, Hinge& h) const {
    SimTK::Vector held;
    system_.getMatterSubsystem().findMotionForces(state, held);
    const Vec3 moment = -h.moment_of(state, held);
    const Rotation turn = h.axes_of_seat(state);
    contact_hold hold{};
    put(hold.reaction,
        ~turn * h.body.findMobilizerReactionOnBodyAtMInGround(state)[1]);
    put(hold.moment, ~turn * moment);
    if (!moment.isFinite()) {
      throw std::runtime_error(
          "resting hinges of a loop must be no more than its freedoms: give "
          "friction to fewer of them");
    }
    put(hold.axis, ~turn * h.axis(state));
    must(contact_joint_at_rest(h.joint.get(), &hold, &h.rest, &h.rest));
    return h.rest.utilisation - 1 - (h.is_ball ? 1e-8 : 1e-10);
  }

  // Speed of a sliding hinge along its slip; 0 where it may have stopped.
  double ahead(const State& state, const Hinge& h) const {
    return dot(h.rate(state), h.direction(state)) -
           (h.is_ball ? options_.stop_speed : 0);
  }

  void settle(State& state) const;
  Vec3 latch(State& state, Hinge& h) const;
  bool is_latched(const State& state, const Hinge& h) const {
    return holds(state)[place_of(h)] == Hold::latch;
  }
  bool is_on_scratch() const { return is_given_; }

  mutable std::vector<Hinge> hinges;
  mutable long evaluations = 0;

 private:
  /// Why a mobilizer is locked, part of the state.
  enum class Hold { none, rest, latch };
  using Holds = SimTK::Array_<Hold>;
  unsigned place_of(const Hinge& h) const {
    return static_cast<unsigned>(&h - hinges.data());
  }
  const Holds& holds(const State& state) const {
    return SimTK::Value<Holds>::downcast(
        forces_.getDiscreteVariable(state, holds_));
  }
  void set_hold(State& state, const Hinge& h, Hold hold) const {
    hold == Hold::none ? h.body.unlock(state) : h.body.lock(state);
    SimTK::Value<Holds>::updDowncast(forces_.updDiscreteVariable(state, holds_))
        .upd()[place_of(h)] = hold;
  }
  void refuse_other_locks(const State& state) const;
  using BodyVectors = SimTK::Vector_<SimTK::SpatialVec>;
  void apply(BodyVectors& forces) const;
  bool aim(const State& state) const;
  void slide() const;
  void converge(const State& state) const;
  void converge_tree(const State& state, const BodyVectors& others) const;
  void note_reactions(const State& state, const BodyVectors& forces,
                      const BodyVectors& accelerations) const;
  bool refit(int turn) const;
  void stop(State& state) const;
  void let_go(State& state, Hinge& h) const;

  using Moments = SimTK::Array_<Vec3>;
  const SimTK::MultibodySystem& system_;
  const SimTK::GeneralForceSubsystem& forces_;
  Options options_;
  mutable MomentFit fit_;
  mutable SimTK::CacheEntryIndex cache_;
  mutable SimTK::DiscreteVariableIndex holds_;
  mutable State scratch_;
  mutable bool is_last_ = false;   // no subsystem of forces comes later
  mutable bool is_given_ = false;  // moments match the hinges' state
};

void HingeFriction::Friction::refuse_other_locks(const State& state) const {
  for (const Hinge& h : hinges) {
    if (!h.body.isLocked(state) || holds(state)[place_of(h)] != Hold::none) {
      continue;
    }
    throw std::runtime_error(
        "mobilized body " + std::to_string(h.body.getMobilizedBodyIndex()) +
        " has friction and was locked by others: HingeFriction::latch() locks "
        "it");
  }
}

// Finds the directions of sliding; true if a hinge slides.
bool HingeFriction::Friction::aim(const State& state) const {
  refuse_other_locks(state);
  bool any = false;
  for (Hinge& h : hinges) {
    h.slides = !h.body.isLocked(state);
    any = any || h.slides;
    if (!h.slides) {
      h.moment = 0;
      continue;
    }
    Vec3 rate = h.rate(state);
    // Smooths friction through the stop, which an event finds.
    const double least = h.is_ball ? options_.stop_speed : 1e-12;
    if (h.can_rest &&
        (h.is_ball ? rate.norm() : dot(rate, h.direction(state))) < least) {
      rate = least * h.direction(state);
    }
    h.from_seat = h.axes_of_seat(state);
    put(h.slip.angular_velocity, ~h.from_seat * rate);
    put(h.slip.axis, ~h.from_seat * h.axis(state));
  }
  return any;
}

// Moments of the sliding hinges under their present reactions.
void HingeFriction::Friction::slide() const {
  for (Hinge& h : hinges) {
    if (!h.slides) continue;
    put(h.slip.reaction, ~h.from_seat * h.reaction);
    must(contact_joint_solve(h.joint.get(), &h.slip, &h.solution, &h.solution));
    h.moment = h.from_seat * vec(h.solution.friction_moment);
  }
}

// Adds moments to the forces of all bodies.
void HingeFriction::Friction::apply(BodyVectors& forces) const {
  for (const Hinge& h : hinges) {
    forces[h.body.getMobilizedBodyIndex()][0] += h.moment;
    forces[h.body.getParentMobilizedBody().getMobilizedBodyIndex()][0] -=
        h.moment;
  }
}

// Moments under the present reactions; true if they are consistent.
bool HingeFriction::Friction::refit(int turn) const {
  constexpr int limit = 100;
  if (turn == limit) {
    throw std::runtime_error("friction and reactions do not come to fit");
  }
  ++evaluations;
  if (turn == 0) fit_.begin();
  const auto moments = [&] {
    Eigen::VectorXd all(3 * hinges.size());
    for (std::size_t i = 0; i < hinges.size(); ++i) {
      all.segment<3>(3 * i) = Eigen::Vector3d(&hinges[i].moment[0]);
    }
    return all;
  };
  Eigen::VectorXd given = moments();
  slide();
  const bool fits = fit_.turn(given, moments());
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    Eigen::Vector3d::Map(&hinges[i].moment[0]) = given.segment<3>(3 * i);
  }
  return fits;
}

// Reactions of a system without closed loops: m a of the links beyond a hinge,
// minus the forces on them.
void HingeFriction::Friction::note_reactions(
    const State& state, const BodyVectors& forces,
    const BodyVectors& accelerations) const {
  const SimTK::SimbodyMatterSubsystem& matter = system_.getMatterSubsystem();
  std::vector<Vec3> needed(matter.getNumBodies(), Vec3(0));
  for (int i = matter.getNumBodies() - 1; i > 0; --i) {
    const SimTK::MobilizedBodyIndex index(i);
    const MobilizedBody& body = matter.getMobilizedBody(index);
    const SimTK::SpatialVec inertial =
        body.getBodySpatialInertiaInGround(state) * accelerations[i] +
        matter.getGyroscopicForce(state, index);
    needed[i] += inertial[1] - forces[i][1];
    needed[body.getParentMobilizedBody().getMobilizedBodyIndex()] += needed[i];
  }
  for (Hinge& h : hinges) h.reaction = needed[h.body.getMobilizedBodyIndex()];
}

// Makes moments and reactions consistent.
void HingeFriction::Friction::converge_tree(const State& state,
                                            const BodyVectors& others) const {
  const SimTK::SimbodyMatterSubsystem& matter = system_.getMatterSubsystem();
  SimTK::Vector rates;
  BodyVectors accelerations;
  for (int turn = 0;; ++turn) {
    BodyVectors forces = others;
    apply(forces);
    matter.calcAccelerationIgnoringConstraints(
        state, system_.getMobilityForces(state, Stage::Dynamics), forces, rates,
        accelerations);
    note_reactions(state, forces, accelerations);
    if (refit(turn)) break;
  }
}

// As above with constraints, and with forces that are not known yet; works on a
// copy of the state, which costs more.
void HingeFriction::Friction::converge(const State& state) const {
  // Restores the state when it ends, also by an exception.
  struct Given {
    explicit Given(bool& is) : is_(is) { is_ = true; }
    ~Given() { is_ = false; }
    bool& is_;
  } const given(is_given_);
  scratch_ = state;
  for (int turn = 0;; ++turn) {
    system_.realize(scratch_, Stage::Acceleration);
    note_reactions(scratch_);
    if (refit(turn)) break;
    scratch_.invalidateAllCacheAtOrAbove(Stage::Dynamics);
  }
}

// Locks hinges without rate, and updates balls that have turned.
void HingeFriction::Friction::stop(State& state) const {
  system_.realize(state, Stage::Velocity);
  std::vector<const Hinge*> stopped;
  for (Hinge& h : hinges) {
    if (!h.can_rest || h.body.isLocked(state)) continue;
    const Vec3 rate = h.rate(state);
    const bool is_slow =
        h.is_ball ? rate.norm() <= 1.5 * options_.stop_speed
                  : dot(rate, h.direction(state)) <= 0 && h.way.norm() > 0;
    if (is_slow || rate.norm() == 0) {
      stopped.push_back(&h);
    } else if (ahead(state, h) <= 0) {
      h.go_along(state, rate);
    }
  }
  for (const Hinge* h : stopped) set_hold(state, *h, Hold::rest);
}

void HingeFriction::Friction::let_go(State& state, Hinge& h) const {
  const Vec3 direction = h.axes_of_seat(state) * vec(h.rest.direction);
  h.go_along(state, direction);
  const SimTK::Vector u =
      h.rates(state, h.is_ball ? 2 * options_.stop_speed * direction : Vec3(0));
  set_hold(state, h, Hold::none);
  h.body.setUFromVector(state, u);
  // Start of the next solution.
  h.solution = h.rest.slip;
}

// By an impulse that removes its rates, and keeps those of constraints and of
// locked mobilizers as they are: with M^-1 of the system and the rows A of
// both, u -> u - M^-1 A^T (A M^-1 A^T)^-1 A u.
Vec3 HingeFriction::Friction::latch(State& state, Hinge& h) const {
  // Friction has no impulse: what rests is ideal in this instant.
  for (const Hinge& other : hinges) {
    if (holds(state)[place_of(other)] == Hold::rest) {
      set_hold(state, other, Hold::none);
    }
  }
  system_.realize(state, Stage::Velocity);
  const SimTK::SimbodyMatterSubsystem& matter = system_.getMatterSubsystem();
  const int first = h.body.getFirstUIndex(state);
  const int own = h.body.getNumU(state);
  SimTK::Matrix constraints;
  matter.calcG(state, constraints);
  SimTK::Matrix rows(own + constraints.nrow(), state.getNU(), 0.0);
  for (int i = 0; i < own; ++i) rows(i, first + i) = 1;
  for (int i = own; i < rows.nrow(); ++i) rows[i] = constraints[i - own];
  SimTK::Matrix moved(state.getNU(), rows.nrow());
  for (int i = 0; i < rows.nrow(); ++i) {
    SimTK::Vector answer;
    matter.multiplyByMInv(state, SimTK::Vector(~rows[i]), answer);
    moved(i) = answer;
  }
  SimTK::Vector impulse;
  SimTK::FactorQTZ(SimTK::Matrix(rows * moved))
      .solve(SimTK::Vector(rows * state.getU()), impulse);
  const SimTK::Vector change = moved * impulse;
  SimTK::Vector loads(state.getNU(), 0.0);
  for (int i = 0; i < own; ++i) loads[first + i] = -impulse[i];
  const Vec3 moment = h.moment_of(state, loads);
  state.updU() -= change;
  h.body.setUFromVector(state, SimTK::Vector(own, 0.0));
  set_hold(state, h, Hold::latch);
  return moment;
}

void HingeFriction::Friction::settle(State& state) const {
  refuse_other_locks(state);
  stop(state);
  // Releases the worst hinge first; a hinge that friction would drive is held
  // again.
  std::vector<Hinge*> released;
  for (std::size_t i = 0; i <= 3 * hinges.size(); ++i) {
    system_.realize(state, Stage::Acceleration);
    for (Hinge* h : released) {
      if (h == released.back() ||
          dot(h->acceleration(state), h->direction(state)) >= 0) {
        continue;
      }
      set_hold(state, *h, Hold::rest);
      released.erase(std::find(released.begin(), released.end(), h));
      system_.realize(state, Stage::Acceleration);
      break;
    }
    Hinge* worst = nullptr;
    double most = 0;
    for (Hinge& h : hinges) {
      if (!h.body.isLocked(state) || is_latched(state, h)) continue;
      const double over = excess(state, h);
      if (over > most) {
        most = over;
        worst = &h;
      }
    }
    if (!worst) break;
    let_go(state, *worst);
    released.push_back(worst);
  }
}

// Event at the end of sliding or rest of a hinge.
class HingeFriction::Event : public SimTK::TriggeredEventHandler {
 public:
  Event(const Friction& friction, std::size_t hinge, bool is_stop)
      : TriggeredEventHandler(is_stop ? Stage::Velocity : Stage::Acceleration),
        friction_(friction),
        hinge_(hinge),
        is_stop_(is_stop) {
    getTriggerInfo().setTriggerOnRisingSignTransition(!is_stop);
    getTriggerInfo().setTriggerOnFallingSignTransition(is_stop);
  }
  double getValue(const State& state) const override {
    if (friction_.is_on_scratch()) return is_stop_ ? 1 : -1;
    Hinge& h = friction_.hinges[hinge_];
    const bool rests = h.body.isLocked(state);
    if (is_stop_) {
      return rests || !h.can_rest ? 1 : friction_.ahead(state, h);
    }
    return rests && !friction_.is_latched(state, h) ? friction_.excess(state, h)
                                                    : -1;
  }
  void handleEvent(State& state, double, bool&) const override {
    friction_.settle(state);
  }

 private:
  const Friction& friction_;
  std::size_t hinge_;
  bool is_stop_;
};

HingeFriction::HingeFriction(SimTK::MultibodySystem& system,
                             SimTK::GeneralForceSubsystem& forces,
                             Options options)
    : system_(system), friction_(new Friction(system, forces, options)) {
  const SimTK::Force::Custom handle(forces, friction_);  // owns friction_
}

void HingeFriction::add(const MobilizedBody& body, const std::string& file) {
  const bool is_ball = MobilizedBody::Ball::isInstanceOf(body) ||
                       MobilizedBody::Gimbal::isInstanceOf(body);
  if (MobilizedBody::Universal::isInstanceOf(body)) {
    throw std::runtime_error(
        "HingeFriction::add: a Universal mobilizer must be two Pins: each of "
        "its axes is a joint with a load of its own");
  }
  if (!is_ball && !MobilizedBody::Pin::isInstanceOf(body)) {
    throw std::runtime_error(
        "HingeFriction::add: body must have a Ball, Gimbal or Pin mobilizer");
  }
  JointHandle joint = read_joint(file, "HingeFriction::add",
                                 is_ball ? CONTACT_BALL : CONTACT_PIN);
  const bool rests = can_rest(joint.get());
  const Seat seat = seat_of(joint.get());
  friction_->hinges.push_back({body, is_ball, std::move(joint), rests, seat});
  const std::size_t i = friction_->hinges.size() - 1;
  if (!rests) return;
  for (const bool is_stop : {true, false}) {
    system_.addEventHandler(new Event(*friction_, i, is_stop));
  }
}

void HingeFriction::settle(State& state) const {
  system_.realize(state, Stage::Velocity);
  for (Hinge& h : friction_->hinges) {
    h.go_along(state, h.rate(state));
  }
  // The present moments belong to other directions.
  state.invalidateAllCacheAtOrAbove(Stage::Velocity);
  friction_->settle(state);
}

Vec3 HingeFriction::latch(State& state, const MobilizedBody& body) const {
  for (Hinge& h : friction_->hinges) {
    if (!h.body.isSameMobilizedBody(body)) continue;
    if (friction_->is_latched(state, h)) return Vec3(0);
    const Vec3 impulse = friction_->latch(state, h);
    settle(state);
    return impulse;
  }
  throw std::runtime_error(
      "HingeFriction::latch: body must be one that add() has had");
}

const contact_solution& HingeFriction::hinge(int i) const {
  return friction_->hinges.at(i).solution;
}

long HingeFriction::evaluations() const { return friction_->evaluations; }

double HingeFriction::power(const State& state) const {
  double sum = 0;
  const auto& moments = friction_->moments(state);
  for (std::size_t i = 0; i < friction_->hinges.size(); ++i) {
    sum += dot(moments[int(i)], friction_->hinges[i].rate(state));
  }
  return sum;
}

}  // namespace contact_hosts::simbody
