#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/duty/wear_map.hpp"
#include "libcontact/files/worn_seat_file.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/quantities/tables.hpp"
#include "python/answers.hpp"
#include "python/contact_warning.hpp"
#include "python/file_joint.hpp"
#include "python/interpreter_lock.hpp"
#include "python/solved.hpp"

namespace contact_python {
namespace {

using Instant = contact::JointCycle::Instant;
using contact::DutyCycle;
using contact::JointBody;
using contact::JointCycle;
using contact::WearMap;
using Eigen::Vector3d;

std::vector<Vector3d> vectors(const char* name, const Numbers& array) {
  std::vector<Vector3d> all;
  Rows({{name, array, 3}}).for_each([&](const double* const* at) {
    all.push_back(vector_at(at[0]));
  });
  return all;
}

JointBody body_of(const char* name, const std::string& text) {
  if (text == "carrier") return JointBody::carrier;
  if (text == "body") return JointBody::body;
  throw contact::Error(contact::detail::must_be(name + (" = \"" + text + "\""),
                                                "\"carrier\" or \"body\""));
}

/// A joint on its duty cycle.
class Cycle {
 public:
  Cycle(const FileJoint& joint, DutyCycle cycle, contact::Lies lies)
      : spec_(joint.spec()),
        on_(std::move(cycle), joint.joint(), std::move(lies),
            [](double /*share*/) { Rows::heed_signals(); }) {}

  const JointCycle& on() const { return on_; }
  const contact::JointGeometry& geometry() const {
    return on_.contact().geometry();
  }
  /// The contact for wear.
  /// @throws contact::Error if it reaches rims
  contact::JointContact endless() const {
    if (on_.joint().is_endless()) return on_.contact();
    if (on_.is_at_rims()) {
      throw contact::Error(contact::detail::needs(
          "wear_in() of contacts at the rims of a [seat]",
          "a joint without it"));
    }
    contact::JointSpec spec = spec_.without_seat();
    spec.half_angle_law = spec_.half_angle_law_name();
    return spec.contact();
  }

 private:
  contact::JointSpec spec_;
  JointCycle on_;
};

// Positions of a pin: one tilt or place, or one for each given row.
contact::Lies lies_of(const DutyCycle& cycle, std::size_t rows,
                      const std::optional<Numbers>& tilt,
                      const std::optional<Numbers>& place) {
  const auto of_times = [&](const char* name, auto all) {
    if (all.size() != 1 && all.size() != rows) {
      throw contact::Error(
          contact::detail::must_be(name, "one, or as many as there are times"));
    }
    all.resize(cycle.times().size(), all[0]);
    return all;
  };
  if (tilt && place) {
    throw contact::Error(
        contact::detail::must_be("tilt", "left out beside place"));
  }
  if (tilt) {
    std::vector<Eigen::Vector2d> tilts;
    for (const Vector3d& each : vectors("tilt", *tilt)) {
      tilts.emplace_back(each.head<2>());
    }
    return contact::tilted_at(cycle.times(), cycle.period(),
                              of_times("tilt", std::move(tilts)));
  }
  if (!place) return {};
  return contact::loaded_at(
      cycle.times(), cycle.period(),
      of_times("place", std::vector<double>(place->data(),
                                            place->data() + place->size())));
}

// Emits a RuntimeWarning at the line `level` Python frames above.
void warn(const std::string& note, int level) {
  if (note.empty()) return;
  if (PyErr_WarnEx(PyExc_RuntimeWarning, note.c_str(), level) != 0) {
    throw py::error_already_set();
  }
}

std::unique_ptr<Cycle> make_cycle(const FileJoint& joint, const Numbers& time,
                                  const Numbers& force, const Numbers& motion,
                                  const std::optional<std::string>& sequence,
                                  std::optional<double> period,
                                  const std::string& force_on,
                                  const std::string& force_in,
                                  const std::optional<Numbers>& tilt,
                                  const std::optional<Numbers>& place) {
  const contact::DutyCycle::ForceFrame frame{body_of("force_on", force_on),
                                             body_of("force_in", force_in)};
  contact::DutyCycle::Rows rows{{time.data(), time.data() + time.size()},
                                vectors("force", force),
                                vectors(sequence ? "angles" : "rates", motion),
                                period};
  warn(rows.make_one_period(), frames_of_maker);
  if (!rows.period) {
    throw contact::Error(contact::detail::needs(
        rows.times.size() == 1 ? "a cycle of one row"
                               : "a cycle with uneven time steps",
        "period, the time from the first row to its return"));
  }
  DutyCycle duty =
      sequence ? DutyCycle(rows, frame, DutyCycle::TurnSequence(*sequence))
               : DutyCycle(rows, frame);
  contact::Lies lies = lies_of(duty, time.size(), tilt, place);
  std::unique_ptr<Cycle> cycle;
  contact::LargestContact largest;
  {
    const Unlocked unlocked;
    cycle = std::make_unique<Cycle>(joint, std::move(duty), std::move(lies));
    largest = cycle->on().largest_contact();
  }
  warn_of(joint.limits(), largest, frames_of_maker);
  for (const std::string& note : cycle->on().rim_notes()) {
    warn_of(note, frames_of_maker);
  }
  for (const std::string& note : cycle->on().cycle().notes(
           cycle->geometry().kind() == contact::JointKind::pin)) {
    warn_of(note, frames_of_maker);
  }
  return cycle;
}

template <class Row, class Function>
Answers<Row> of_rows(const Cycle& cycle, const Function& row) {
  Answers<Row> all{{py::ssize_t(cycle.on().rows().size())}, {}};
  for (const auto& i : cycle.on().rows()) all.rows.push_back(row(i));
  return all;
}

// A quantity by its attribute's name; for a vector its length.
JointCycle::Quantity quantity(const Cycle& cycle, const std::string& name) {
  if (name == "half_angle") {
    return [&cycle](const Instant& i) { return cycle.on().half_angle(i); };
  }
  if (const auto* q = find_quantity(contact::solution_quantities(), name)) {
    return [q](const Instant& i) { return number_of(*q, i.solution); };
  }
  if (const auto* q = find_quantity(contact::rating_quantities(), name)) {
    return [q, &cycle](const Instant& i) {
      return number_of(*q, cycle.on().rating(i));
    };
  }
  if (const auto* q = find_quantity(contact::lie_quantities(), name)) {
    return [q, &cycle](const Instant& i) {
      const auto lie = cycle.on().joint().lie(i.solution);
      return lie ? number_of(*q, *lie) : contact::detail::nan;
    };
  }
  throw contact::Error(contact::detail::must_be(
      "quantity = \"" + name + "\"", "an attribute of Solution or Rating"));
}

py::object largest(const Cycle& cycle, const std::string& name) {
  const auto of = quantity(cycle, name);
  Instant instant;
  {
    const Unlocked unlocked;
    instant = name == "peak_pressure" ? cycle.on().largest_peak()
              : name == "pv_max"      ? cycle.on().largest_pv()
                                      : cycle.on().largest(of);
  }
  return py::make_tuple(of(instant), instant.time);
}

py::array_t<double> array_of(const std::vector<Vector3d>& vectors) {
  py::array_t<double> array({py::ssize_t(vectors.size()), py::ssize_t{3}});
  double* to = array.mutable_data();
  for (const Vector3d& v : vectors) {
    for (const double x : v) *to++ = x;
  }
  return array;
}

py::dict wear(const Cycle& cycle, const std::string& body, int points) {
  if (points < 10) {
    throw contact::Error(contact::detail::must_be(
        "points = " + std::to_string(points), "10 or more"));
  }
  const JointBody of = body_of("body", body);
  std::vector<Vector3d> grid;
  std::vector<WearMap::Wear> worn;
  WearMap::Deepest deepest;
  double cell_area;
  double defect;
  {
    const Unlocked unlocked;
    const WearMap map(cycle.on(), of);
    grid = map.grid(points);
    worn = map.at(grid);
    deepest = map.deepest(grid, worn);
    defect = map.volume_defect(worn);
    cell_area = map.cell_area(points);
  }
  py::array_t<double> pv(worn.size());
  py::array_t<double> cross_shear(worn.size());
  for (std::size_t i = 0; i < worn.size(); ++i) {
    pv.mutable_at(i) = worn[i].pv;
    cross_shear.mutable_at(i) = worn[i].cross_shear;
  }
  using namespace py::literals;  // NOLINT: _a
  return py::dict("body"_a = body, "points"_a = array_of(grid),
                  "pv_integral"_a = pv, "cross_shear"_a = cross_shear,
                  "cell_area"_a = cell_area, "volume_defect"_a = defect,
                  "deepest_point"_a = array_of({deepest.point})[py::int_(0)],
                  "deepest_pv_integral"_a = deepest.wear.pv,
                  "deepest_cross_shear"_a = deepest.wear.cross_shear);
}

/// Wear of a seat or hole, kept between calls and files.
class WornSeat {
 public:
  WornSeat() = default;
  WornSeat(contact::WornSeat seat, const contact::JointGeometry& geometry)
      : seat_(std::move(seat)), geometry_(geometry) {}

  const contact::WornSeat& seat() const { return seat_; }
  // @throws contact::Error if there is no wear
  std::string toml() const {
    if (geometry_) return contact::worn_seat_text(seat_, *geometry_);
    throw contact::Error(
        contact::detail::needs("to_toml()", "a seat that is worn"));
  }

 private:
  contact::WornSeat seat_;
  std::optional<contact::JointGeometry> geometry_;
};

// @param seat  existing wear to continue from, if not null
Answers<contact::WearIn::State> wear_in(const Cycle& cycle, double coefficient,
                                        double cycles, double inner,
                                        WornSeat* seat,
                                        const py::object& progress) try {
  contact::WearIn worn;
  {
    const Unlocked unlocked;
    worn = contact::wear_in(cycle.on().cycle(), cycle.endless(),
                            {coefficient, inner}, cycles,
                            seat ? &seat->seat() : nullptr, [&](double done) {
                              Rows::heed_signals();
                              if (progress.is_none()) return;
                              const Locked locked;
                              tell(progress, py::make_tuple(done, cycles));
                            });
  }
  if (seat) *seat = {std::move(worn.worn), cycle.geometry()};
  const Instant first = cycle.on().rows()[0];
  if (cycle.on().joint().lie(first.solution)) {
    worn.notes.emplace_back("the pin is taken level and without its ends");
  }
  for (const std::string& note : worn.notes) warn(note, 2);
  return {{py::ssize_t(worn.states.size())}, std::move(worn.states)};
} catch (const contact::Error& error) {
  // Wear beyond the radius is mostly k in another unit.
  const std::string note = contact::WearMap::coefficient_note(coefficient);
  if (note.empty()) throw;
  throw contact::Error(error.what() + ("; " + note));
}

void bind_worn_seat(py::module_& m) {
  py::class_<WornSeat> type(m, "WornSeat", R"(WornSeat()
--

Wear of a seat or hole, in the axes of its body; Cycle.wear_in() continues from it
(libcontact's docs/explanation/wear.md).)");
  type.def(py::init<>())
      .def_static(
          "from_file",
          [](const std::filesystem::path& path, const FileJoint& joint) {
            const contact::JointGeometry& geometry = joint.spec().geometry;
            return WornSeat(contact::read_worn_seat(path, geometry), geometry);
          },
          py::arg("path"), py::arg("joint"),
          R"(from_file(path, joint)
--

Reads a file of hinge-duty --worn-out or to_toml(), for a joint of this kind,
radius and clearance.)")
      .def("to_toml", &WornSeat::toml, R"(to_toml(self)
--

The text of such a file with all digits.)")
      .def_property_readonly(
          "depths",
          [](const WornSeat& s) {
            return py::array_t<double>(py::cast(s.seat().depths));
          },
          "m, (n,): of a hole at even points of the circle from X towards Y, "
          "of "
          "a seat at the cells of a grid.")
      .def_property_readonly(
          "cycles", [](const WornSeat& s) { return s.seat().cycles; },
          "In which it went.");
}

void bind_sums(std::span<const contact::Quantity<JointCycle>> quantities,
               py::class_<Cycle>& type) {
  for (const auto& q : quantities) {
    type.def_property_readonly(
        q.key.data(),
        [&q](const Cycle& c) {
          const Unlocked unlocked;
          return value_of(q, c.on());
        },
        documentation(q).c_str());
  }
}

}  // namespace

void bind_duty(py::module_& m) {
  py::class_<Cycle> type(m, "Cycle", "A joint on a duty cycle.");
  type.def(py::init(&make_cycle), py::arg("joint"), py::arg("time"),
           py::arg("force"), py::arg("motion"), py::arg("sequence"),
           py::arg("period"), py::arg("force_on"), py::arg("force_in"),
           py::arg("tilt"), py::arg("place"));
  const auto sums = contact::cycle_quantities();
  const auto worst = contact::worst_quantities();
  bind_sums(sums, type);
  bind_sums(worst, type);
  type.attr("_quantities") =
      detail::quantities_of(sums) + detail::quantities_of(worst);
  type.def_property_readonly(
      "time",
      [](const Cycle& c) {
        return py::array_t<double>(py::cast(c.on().cycle().times()));
      },
      "Of the rows, s.");
  type.def_property_readonly(
      "solution",
      [](const Cycle& c) {
        return of_rows<Solved>(c, [&](const Instant& i) {
          return Solved(c.on().joint(), i.solution);
        });
      },
      "Friction at the rows, axes of the carrier: a Solution.");
  type.def_property_readonly(
      "rating",
      [](const Cycle& c) {
        return of_rows<contact::SlidingContact::Rating>(
            c, [&](const Instant& i) { return c.on().rating(i); });
      },
      "p v and heat at the rows: a Rating.");
  type.def_property_readonly(
      "table",
      [](const Cycle& c) -> std::optional<py::bytes> {
        const std::string table = c.on().joint().table();
        if (table.empty()) return {};
        return table;
      },
      "The table of contacts at rims as bytes to keep; None if there is none.");
  type.def("largest", &largest, py::arg("quantity"),
           R"(largest(self, quantity)
--

The largest value in the cycle and its time, s; accurate to 1e-8. If the cycle
reaches a rim, it is the largest of the rows, and NaN if it is undefined in a row:
half-angles and heat fluxes. The half-angle of a finite-length pin is the largest
along it.

quantity: an attribute of Solution or Rating; for a vector its length.)");
  bind_worn_seat(m);
  bind_answers(m, "WearIn", contact::worn_quantities(),
               "What Cycle.wear_in() returns.");
  type.def(
      "wear_in", &wear_in, py::arg("coefficient"), py::arg("cycles"),
      py::kw_only(), py::arg("inner") = 0, py::arg("seat") = py::none(),
      py::arg("progress") = py::none(),
      R"(wear_in(self, coefficient, cycles, *, inner=0, seat=None, progress=None)
--

The joint over many cycles in which wear of the seat or hole widens the contact
(libcontact's docs/how-to/duty.md): a WearIn of blocks, (n,). The first block is
without wear, the last after all cycles; in a block the worn volume grows by at
most 10 % of the overlap of the bodies.

If contact_spread is above 0.1 of the half-angle, or a pin has no clearance, the
depth of wear adds to the gap at points of the seat, and the contact is solved by
elasticity alone, with a RuntimeWarning if the joint has other laws.

coefficient: k of the seat or hole, m^2/N; 1 mm^3/(N m) is 1e-9 m^2/N.
cycles: number of cycles.
inner: k of the ball or pin; only for a pin without clearance or with
    interference (docs/explanation/wear.md).
seat: a WornSeat to continue from; the seat then wears at points for any load.
progress: called at each block with the cycles done and all; an exception, also
    by Ctrl-C, ends the computation.)");
  type.def("_wear", &wear, py::arg("body"), py::arg("points"));
}

}  // namespace contact_python
