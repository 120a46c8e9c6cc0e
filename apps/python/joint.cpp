#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <mutex>

#include "libcontact/base/complaint.hpp"
#include "libcontact/half_angle/registry.hpp"
#include "libcontact/pressure/registry.hpp"
#include "libcontact/quantities/tables.hpp"
#include "python/answers.hpp"
#include "python/contact_warning.hpp"
#include "python/file_joint.hpp"

namespace contact_python {
namespace {

using contact::JointContact;
using contact::JointSolution;
using contact::JointSpec;
using contact::RestSolution;
using contact::SlidingContact;
using contact::TomlTable;
using Eigen::Vector3d;

// Solutions, with warnings of their largest contact.
template <class Solve>
Answers<JointSolution> solutions(const FileJoint& self,
                                 std::initializer_list<Argument> arguments,
                                 const Solve& solve) {
  contact::LargestContact largest;
  auto all = answers<JointSolution>(arguments, [&](const double* const* at) {
    const JointSolution s = solve(at);
    largest.add(s.half_angle, s.peak_pressure);
    return s;
  });
  warn_of(self.limits(), largest);
  return all;
}

// What rows start from: each from that of the same number, or all from one.
// Unpickled results have nothing to start from.
template <class Row>
class Starts {
 public:
  Starts(const Answers<Row>* last, const Rows& rows)
      : last_(last && !last->rows.empty() ? &last->rows : nullptr) {
    if (last && !last->shape.empty() && last->shape != rows.shape()) {
      throw contact::Error(contact::detail::must_be(
          "last", "one result, or of the shape of the rows"));
    }
  }
  // Null where there is nothing.
  const Row* operator()(std::size_t i) const {
    if (!last_) return nullptr;
    return &(*last_)[last_->size() == 1 ? 0 : i];
  }

 private:
  const std::vector<Row>* last_;
};

// The largest contact of many threads.
class LargestOfAll {
 public:
  void add(const contact::LargestContact& other) {
    const std::lock_guard lock(mutex_);
    largest_.add(other);
  }
  const contact::LargestContact& operator()() const { return largest_; }

 private:
  std::mutex mutex_;
  contact::LargestContact largest_;
};

// Solutions of rows in turn, one from the other if they are warm.
class Solver {
 public:
  using Start = Starts<JointSolution>;
  Solver(const contact::Joint& joint, const Start& start, bool warm,
         LargestOfAll& largest)
      : joint_(joint), start_(start), warm_(warm), all_(largest) {}
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  ~Solver() { all_.add(largest_); }

  const JointSolution& operator()(const double* const* at, std::size_t i) {
    const contact::Joint::Slip slip{vector_at(at[0]), vector_at(at[1]),
                                    vector_at(at[2])};
    const JointSolution* start = start_(i);
    if (warm_ && has_last_) start = &last_;
    last_ = start ? joint_.solve(slip, *start) : joint_.solve(slip);
    has_last_ = true;
    largest_.add(last_.half_angle, last_.peak_pressure);
    return last_;
  }

 private:
  const contact::Joint& joint_;
  const Start& start_;
  bool warm_;
  bool has_last_ = false;
  JointSolution last_;
  contact::LargestContact largest_;
  LargestOfAll& all_;
};

py::object solve(const FileJoint& self, const Numbers& reaction,
                 const Numbers& angular_velocity,
                 const std::optional<Numbers>& axis, bool warm,
                 const Answers<JointSolution>* last,
                 const std::optional<std::vector<std::string>>& fields,
                 const std::optional<py::dict>& out, int threads) {
  if (threads < 1) {
    throw contact::Error(contact::detail::must_be(
        "threads = " + std::to_string(threads), "1 or more"));
  }
  const contact::Joint& joint = self.joint();
  const Vector3d none = Vector3d::Zero();
  const Rows rows({{"reaction", reaction, 3},
                   {"angular_velocity", angular_velocity, 3},
                   axis ? Argument("axis", *axis, 3) : Argument(none)});
  const Starts starts(last, rows);
  LargestOfAll largest;
  const auto solve_into = [&](const auto& put) {
    rows.for_each(threads, [&] {
      return [&put,
              solver = std::make_unique<Solver>(joint, starts, warm, largest)](
                 const double* const* at, std::size_t i) {
        put(i, (*solver)(at, i));
      };
    });
    warn_of(self.limits(), largest());
  };
  if (fields || out) {
    const ChosenColumns<JointSolution> chosen(contact::solution_quantities(),
                                              fields, out, rows.shape());
    solve_into(chosen);
    return chosen.arrays();
  }
  Answers<JointSolution> all{rows.shape()};
  all.rows.resize(rows.size());
  solve_into([&](std::size_t i, const JointSolution& s) { all.rows[i] = s; });
  return py::cast(std::move(all));
}

Answers<JointSolution> solve_contact(const FileJoint& self,
                                     const Numbers& normal_force,
                                     const Numbers& angular_velocity,
                                     const std::optional<Numbers>& axis) {
  const contact::Joint& joint = self.joint();
  const Vector3d none = Vector3d::Zero();
  return solutions(
      self,
      {{"normal_force", normal_force, 3},
       {"angular_velocity", angular_velocity, 3},
       axis ? Argument("axis", *axis, 3) : Argument(none)},
      [&](const double* const* at) {
        return joint.solve_contact(
            {vector_at(at[0]), vector_at(at[1]), vector_at(at[2])});
      });
}

Answers<RestSolution> at_rest(const FileJoint& self, const Numbers& reaction,
                              const Numbers& moment,
                              const std::optional<Numbers>& axis,
                              const Answers<RestSolution>* last) {
  const contact::Joint& joint = self.joint();
  const Vector3d none = Vector3d::Zero();
  const Rows rows({{"reaction", reaction, 3},
                   {"moment", moment, 3},
                   axis ? Argument("axis", *axis, 3) : Argument(none)});
  const Starts starts(last, rows);
  contact::LargestContact largest;
  Answers<RestSolution> all{rows.shape()};
  all.rows.reserve(rows.size());
  rows.for_each([&](const double* const* at) {
    const contact::Joint::Hold hold{vector_at(at[0]), vector_at(at[1]),
                                    vector_at(at[2])};
    const RestSolution* const start = starts(all.rows.size());
    const RestSolution s =
        start ? joint.at_rest(hold, *start) : joint.at_rest(hold);
    largest.add(s.slip.half_angle, s.slip.peak_pressure);
    all.rows.push_back(s);
  });
  warn_of(self.limits(), largest);
  return all;
}

Answers<contact::SlidingContact::Rating> pv(const FileJoint& self,
                                            const Numbers& reaction,
                                            const Numbers& angular_velocity) {
  const contact::Joint& joint = self.joint();
  contact::LargestContact largest;
  auto all = answers<contact::SlidingContact::Rating>(
      {{"reaction", reaction, 3}, {"angular_velocity", angular_velocity, 3}},
      [&](const double* const* at) {
        const Vector3d rate = vector_at(at[1]);
        const JointSolution s = joint.solve({vector_at(at[0]), rate});
        largest.add(s.half_angle, s.peak_pressure);
        return SlidingContact(joint.contact(), s, rate).rating();
      });
  warn_of(self.limits(), largest);
  return all;
}

// Over places of the contact of one state.
py::dict pv_at(const FileJoint& self, const Vector3d& reaction,
               const Vector3d& rate, const Numbers& places) {
  const contact::Joint& joint = self.joint();
  const JointSolution s = joint.solve({reaction, rate});
  warn_of(self.limits(), {s.half_angle, s.peak_pressure});
  const SlidingContact sliding(joint.contact(), s, rate);
  const auto over = [&](double (SlidingContact::*of)(const Vector3d&)
                            const noexcept) {
    return evaluate({{"places", places, 3}}, [&](const double* const* at) {
      return (sliding.*of)(vector_at(at[0]));
    });
  };
  py::dict result;
  result["pressure"] = over(&SlidingContact::pressure);
  result["pv"] = over(&SlidingContact::pv);
  result["heat_flux"] = over(&SlidingContact::heat_flux);
  return result;
}

JointSpec checked_spec(const TomlTable& file) {
  JointSpec spec = contact::joint_from_table(file);
  file.refuse_idle();
  return spec;
}

JointContact contact_of(JointSpec spec) {
  if (!spec.friction) spec.friction = contact::FrictionLaw(0);
  return spec.contact();
}

// A file that another one names with its key `kind`, with settings: a joint or
// a pair of materials.
std::string file_toml(const std::string& kind,
                      const std::filesystem::path& path,
                      const Settings& settings) {
  contact::KnownKeys keys = contact::joint_keys();
  if (kind == "pair") {
    const auto of = [](const contact::KnownKeys& all, std::string_view key) {
      return *std::ranges::find(all, key, &contact::KnownKey::key);
    };
    keys = of(of(keys, "materials").inside, kind).of_file;
  }
  return TomlTable::from_file(path, keys, key_settings(settings)).toml_text();
}

constexpr const char* solve_doc =
    R"(solve(self, reaction, angular_velocity, *, axis=None, warm=False, last=None, fields=None, out=None, threads=1)
--

Friction of the joint while its halves turn, under a known reaction.

reaction: R on the body, N, (..., 3).
angular_velocity: Dw, body against carrier, rad/s, (..., 3); 0 rests.
axis: of a pin, unit vector, (..., 3); the direction of Dw if it is None.
warm: begin each row from the solution of the row before. Rows that are near
    each other take 0.2 to 0.7 of the time; the last digits differ.
last: a Solution of this joint for similar rows, from which each row begins,
    of their shape or a single one; an unpickled one has nothing to begin from.
fields: names of the quantities that are wanted, as "friction_moment": they
    alone are kept, and returned as a dict of arrays.
out: arrays for them by their names, as a dict, which is returned.
threads: how many share the rows; rows do not change by it unless they are
    warm: these begin anew every 1024.

 a Solution of the shape to which the arguments broadcast. To 2e-13 of
the equations; NaN in an argument gives NaN with Status.OUT_OF_RANGE.)";

void bind_solutions(py::class_<FileJoint>& type) {
  const auto keyword_axis = py::arg("axis") = py::none();
  type.def("solve", &solve, py::arg("reaction"), py::arg("angular_velocity"),
           py::kw_only(), keyword_axis, py::arg("warm") = false,
           py::arg("last") = py::none(), py::arg("fields") = py::none(),
           py::arg("out") = py::none(), py::arg("threads") = 1, solve_doc);
  type.def("solve_contact", &solve_contact, py::arg("normal_force"),
           py::arg("angular_velocity"), py::kw_only(), keyword_axis,
           R"(solve_contact(self, normal_force, angular_velocity, *, axis=None)
--

Friction under a known normal force: nothing to solve. With the reaction in its
place it is the traditional estimate.

normal_force: R_n n on the body, N, (..., 3).
angular_velocity, axis: as in solve().)");
  type.def("at_rest", &at_rest, py::arg("reaction"), py::arg("moment"),
           py::kw_only(), keyword_axis, py::arg("last") = py::none(),
           R"(at_rest(self, reaction, moment, *, axis=None, last=None)
--

Whether the joint rests under a reaction while friction supplies a moment, and
how near it is to sliding.

reaction: R on the body, N, (..., 3).
moment: M on the body that friction has to supply, N m, (..., 3).
last: a RestSolution for similar rows, as in solve(): a fifth of the time.

Returns a RestSolution.)");
  type.def("pv", &pv, py::arg("reaction"), py::arg("angular_velocity"),
           R"(pv(self, reaction, angular_velocity)
--

p v and heat over the contact while the halves turn: their largest values with
the place, means, sums. Arguments as in solve(). Returns a Rating.)");
  type.def(
      "pv_at",
      [](const FileJoint& self, std::array<double, 3> reaction,
         std::array<double, 3> rate, const Numbers& places) {
        return pv_at(self, vector_at(reaction.data()), vector_at(rate.data()),
                     places);
      },
      py::arg("reaction"), py::arg("angular_velocity"), py::arg("places"),
      R"(pv_at(self, reaction, angular_velocity, places)
--

A dict of "pressure" (Pa), "pv" and "heat_flux" (W/m^2) at places of the
contact of one state; pressure and heat flux are 0 outside of it.

reaction, angular_velocity: as in solve(), (3,).
places: unit vectors from the joint's centre, (..., 3).)");
}

}  // namespace

FileJoint::FileJoint(const std::string& text, const std::string& source,
                     const std::filesystem::path& folder,
                     const contact::KeySettings& settings)
    : FileJoint(TomlTable::from_text(text, source, contact::joint_keys(),
                                     folder, settings)) {}

FileJoint::FileJoint(const TomlTable& file)
    : toml_(file.toml_text()),
      spec_(checked_spec(file)),
      canonical_(spec_.canonical_text()),
      joint_(contact_of(spec_)),
      limits_(contact().limits()) {}

contact::KeySettings key_settings(const Settings& settings) {
  contact::KeySettings all;
  for (const auto& [key, value] : settings) all.push_back({key, value});
  return all;
}

const contact::Joint& FileJoint::joint() const {
  if (!spec_.friction) spec_.contact();  // says so
  return joint_;
}

namespace {

// Laws that depend on the materials.
std::vector<std::string> material_laws() {
  namespace laws = contact::detail;
  const auto depends = [](const auto& entry) {
    return entry.about.needs != laws::LawEntry::Needs::nothing;
  };
  auto names = laws::names_of(laws::half_angle_entries(), depends);
  for (auto& name : laws::names_of(laws::pressure_entries(), depends)) {
    names.push_back(std::move(name));
  }
  return names;
}

// A key with each unit that it may have.
std::vector<std::string> spellings(const contact::KnownKey& known) {
  const std::string key(known.key);
  std::vector<std::string> all;
  for (const contact::Unit& unit : units_of(known.dimension)) {
    all.push_back(key + (unit.ending.empty() ? "" : "_") +
                  std::string(unit.ending));
  }
  if (all.front() != key) all.insert(all.begin(), key);
  return all;
}

// The keys of joint files: of tables the spellings of theirs.
py::dict joint_keys() {
  py::dict tables;
  for (const contact::KnownKey& known : contact::joint_keys()) {
    py::list inside;
    for (const contact::KnownKey& key : known.inside)
      for (const std::string& name : spellings(key)) inside.append(name);
    for (const std::string& name : spellings(known))
      tables[name.c_str()] = inside;
  }
  return tables;
}

}  // namespace

void bind_joint(py::module_& m) {
  m.attr("_material_laws") = material_laws();
  m.attr("_joint_keys") = joint_keys();
  bind_answers(m, "Solution", contact::solution_quantities(),
               "What Joint.solve() returns, and Joint.solve_contact().");
  bind_answers(m, "RestSolution", contact::rest_quantities(),
               "What Joint.at_rest() returns.");
  bind_answers(m, "Rating", contact::rating_quantities(),
               "What Joint.pv() returns.");
  py::class_<FileJoint> type(m, "Joint");
  type.def(py::init([](const std::string& text, const std::string& source,
                       const std::filesystem::path& folder,
                       const Settings& settings) {
             return std::make_unique<FileJoint>(text, source, folder,
                                                key_settings(settings));
           }),
           py::arg("text"), py::arg("source"), py::arg("folder"),
           py::arg("settings"), py::call_guard<Unlocked>());
  type.def_property_readonly("_toml", &FileJoint::toml);
  type.def_property_readonly("_canonical", &FileJoint::canonical);
  m.def("_file_toml", &file_toml);
  bind_contact(m, type);
  bind_solutions(type);
}

}  // namespace contact_python
