#include <pybind11/stl.h>

#include "libcontact/quantities/play.hpp"
#include "python/answers.hpp"
#include "python/contact_warning.hpp"
#include "python/file_joint.hpp"

namespace contact_python {
namespace {

using contact::ForceState;
using contact::HuntCrossley;
using contact::Impact;
using contact::PlayForce;
using contact::PlayMotion;

// A joint with play; its tables are built once.
class Play {
 public:
  Play(const FileJoint& joint, double damping, double regularisation_speed)
      : name_(joint.spec().name),
        impact_(joint.spec()),
        joint_(joint.spec(), {HuntCrossley(damping), regularisation_speed},
               impact_.force_law()),
        limits_(joint.limits()) {}

  const std::string& name() const { return name_; }
  const contact::PlayJoint& joint() const { return joint_; }
  const contact::ForceLaw& law() const { return joint_.force_law(); }
  const contact::JointImpact& impacts() const { return impact_; }
  const contact::ContactLimits& limits() const { return limits_; }

 private:
  std::string name_;
  contact::JointImpact impact_;
  contact::PlayJoint joint_;
  contact::ContactLimits limits_;
};

Answers<ForceState> force_law(const Play& self, const Numbers& penetration) {
  return answers<ForceState>(
      {{"penetration", penetration, 0}},
      [&](const double* const* at) { return self.law().at(*at[0]); });
}

Answers<Impact> impact(const Play& self, const Numbers& mass,
                       const Numbers& speed) {
  contact::LargestContact largest;
  auto all = answers<Impact>(
      {{"mass", mass, 0}, {"speed", speed, 0}}, [&](const double* const* at) {
        const Impact i = self.impacts()(self.joint().damping(), *at[0], *at[1]);
        largest.add(i.half_angle, i.peak_pressure);
        return i;
      });
  warn_of(self.limits(), largest);
  return all;
}

PlayMotion motion_at(const double* const* at) {
  return {vector_at(at[0]), vector_at(at[1]), vector_at(at[2]),
          vector_at(at[3])};
}

Answers<PlayForce> evaluate_force(const Play& self, const Numbers& position,
                                  const Numbers& velocity,
                                  const Numbers& angular_velocity,
                                  const std::optional<Numbers>& axis) {
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  return answers<PlayForce>(
      {{"position", position, 3},
       {"velocity", velocity, 3},
       {"angular_velocity", angular_velocity, 3},
       axis ? Argument("axis", *axis, 3) : Argument(z)},
      [&](const double* const* at) { return self.joint()(motion_at(at)); });
}

py::array derivatives(const Play& self, const Numbers& position,
                      const Numbers& velocity, const Numbers& angular_velocity,
                      const std::optional<Numbers>& axis) {
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  const Rows rows({{"position", position, 3},
                   {"velocity", velocity, 3},
                   {"angular_velocity", angular_velocity, 3},
                   axis ? Argument("axis", *axis, 3) : Argument(z)});
  Shape shape = rows.shape();
  shape.insert(shape.end(), {6, 9});
  py::array_t<double> result(shape);
  double* to = result.mutable_data();
  rows.for_each([&](const double* const* at) {
    contact::PlayDerivatives d;
    self.joint()(motion_at(at), d);
    Eigen::Map<Eigen::Matrix<double, 6, 9, Eigen::RowMajor>>{to} = d;
    to += d.size();
  });
  return result;
}

}  // namespace

namespace {

void bind_force_law(py::class_<Play>& type) {
  type.def("force_law", &force_law, py::arg("penetration"),
           R"(force_law(self, penetration)
--

The exact elastic force over the penetration from first touch, m. Returns a
ForceState; NaN above largest_penetration.)")
      .def_property_readonly(
          "largest_penetration",
          [](const Play& p) { return p.law().largest_penetration(); },
          "Where the force law ends, m.")
      .def("impact", &impact, py::arg("mass"), py::arg("speed"),
           R"(impact(self, mass, speed)
--

An impact under the contact force alone. Returns an Impact; NaN beyond the force
law.

mass: kg, of two bodies m1 m2/(m1 + m2).
speed: at touch, m/s.)")
      .def(
          "impact_notes",
          [](const Play& p, double mass, double speed, double density) {
            return p.impacts().notes(
                p.impacts()(p.joint().damping(), mass, speed), density);
          },
          py::arg("mass"), py::arg("speed"), py::arg("density") = 0.0,
          R"(impact_notes(self, mass, speed, density=0.0)
--

Where an impact exceeds the limits of the model, a sentence each. density: kg/m^3;
without it waves are not checked.)");
}

void bind_motion(py::class_<Play>& type) {
  const auto keyword_axis = py::arg("axis") = py::none();
  type.def("force", &evaluate_force, py::arg("position"), py::arg("velocity"),
           py::arg("angular_velocity"), py::kw_only(), keyword_axis,
           R"(force(self, position, velocity, angular_velocity, *, axis=None)
--

Force and moment on the ball or pin. Returns a PlayForce; NaN beyond the force law.

position: of its centre from the seat's centre, m, (..., 3), in a frame of the
    seat.
velocity: of its centre, m/s, (..., 3).
angular_velocity: relative to the seat, rad/s, (..., 3).
axis: of a pin, unit vector, (..., 3); z if it is None.)")
      .def(
          "derivatives", &derivatives, py::arg("position"), py::arg("velocity"),
          py::arg("angular_velocity"), py::kw_only(), keyword_axis,
          R"(derivatives(self, position, velocity, angular_velocity, *, axis=None)
--

Derivatives of force and moment (6) over position, velocity and angular velocity
(9), (..., 6, 9).
Arguments as in force().)")
      .def(
          "notes",
          [](const Play& p, std::array<double, 3> position,
             std::array<double, 3> velocity,
             std::array<double, 3> angular_velocity,
             std::array<double, 3> axis) {
            return p.joint().notes(
                {vector_at(position.data()), vector_at(velocity.data()),
                 vector_at(angular_velocity.data()), vector_at(axis.data())});
          },
          py::arg("position"), py::arg("velocity"), py::arg("angular_velocity"),
          py::arg("axis") = std::array<double, 3>{0, 0, 1},
          R"(notes(self, position, velocity, angular_velocity, axis=(0, 0, 1))
--

Where a state exceeds the limits of the model, a sentence each.)");
}

}  // namespace

void bind_play(py::module_& m) {
  bind_answers(m, "ForceState", contact::force_state_quantities(),
               "What Play.force_law() returns.");
  bind_answers(m, "Impact", contact::impact_quantities(),
               "What Play.impact() returns.");
  bind_answers(m, "PlayForce", contact::play_force_quantities(),
               "What Play.force() returns.");
  m.def(
      "damping_of_restitution",
      [](double restitution, double speed) {
        return HuntCrossley::from_restitution(restitution, speed).damping();
      },
      py::arg("restitution"), py::arg("speed"),
      R"(damping_of_restitution(restitution, speed)
--

The damping a in F (1 + a d penetration/dt), s/m, that gives an impact at this
speed, m/s, this restitution, above 0 to 1: exact for every force law and mass.)");
  py::class_<Play> type(m, "Play",
                        R"(Play(joint, damping=0, regularisation_speed=1e-3)
--

A joint with play as a force instead of a constraint: its ball or pin moves freely in
the clearance, touches the seat and is pressed into it.

joint: a Joint; a pin needs a wall with a backing. Its friction must be dry.
damping: a in F (1 + a d penetration/dt), s/m: damping_of_restitution().
regularisation_speed: below which friction fades, m/s.)");
  type.def(py::init([](const FileJoint& joint, double damping, double speed) {
             const Unlocked unlocked;
             return std::make_unique<Play>(joint, damping, speed);
           }),
           py::arg("joint"), py::arg("damping") = 0.0,
           py::arg("regularisation_speed") = 1e-3);
  type.def("__repr__", [](const Play& p) {
    return py::str(
               "<libcontact.Play of {!r}, damping {:g} s/m, up to {:.4g} m>")
        .format(p.name(), p.joint().damping().damping(),
                p.law().largest_penetration());
  });
  bind_force_law(type);
  bind_motion(type);
}

}  // namespace contact_python
