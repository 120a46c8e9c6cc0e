#include "multibody/system/system.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "libcontact/base/linear/parts.hpp"
#include "multibody/system/hinges/kinds.hpp"
#include "multibody/system/hinges/link_checks.hpp"
#include "multibody/system/tree_order.hpp"

namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

void check_mass(double mass, const std::string& place) {
  if (std::isfinite(mass) && mass > 0) return;
  refuse(fmt::format("{}.mass = {} kg", place, mass), "above 0 and finite");
}

void check_finite(const Vector3d& v, const std::string& place) {
  if (!v.allFinite()) refuse(place, "finite");
}

// The symmetric part; principal moments >= 0, or all > 0.
Matrix3d checked_inertia(const Matrix3d& inertia, bool positive,
                         const std::string& place) {
  if (!inertia.allFinite()) refuse(place, "finite");
  const double scale = inertia.cwiseAbs().maxCoeff();
  const double skew = (inertia - inertia.transpose()).cwiseAbs().maxCoeff();
  // Products of inertia printed with seven digits still pass.
  if (skew > 1e-6 * scale) {
    refuse(place, fmt::format("symmetric, it is off by {} kg m^2", skew));
  }
  Matrix3d symmetric = 0.5 * (inertia + inertia.transpose());
  const double smallest = contact::detail::symmetric_parts(symmetric).values[0];
  if (positive ? smallest <= zero_inertia * scale
               : smallest < -zero_inertia * scale) {
    refuse(fmt::format("{}: smallest principal moment = {} kg m^2", place,
                       smallest),
           positive ? above_rounding(scale) : "0 or above");
  }
  return symmetric;
}

Link make_link(Body body, const std::string& place) {
  check_mass(body.mass, place);
  body.inertia = checked_inertia(body.inertia, body.kind == HingeKind::none,
                                 place + ".inertia_com");
  check_finite(body.hinge_from_com, place + ".hinge_from_com");
  check_finite(body.hinge_from_carrier_com, place + ".hinge_from_carrier_com");
  Link link = with_hinge(body.kind,
                         [&](auto hinge) { return hinge.link(body, place); });
  link.kind = body.kind;
  link.mass = body.mass;
  link.parent = body.parent;
  if (body.kind == HingeKind::none && body.parent >= 0) {
    refuse(place + ".parent", "-1 for a body without a hinge");
  }
  return link;
}

// The star has a limit for a point on a thread, which does not spin.
void check_spin(const Link& link, const std::string& place) {
  if (link.kind == HingeKind::ball && link.inertia(2, 2) == 0) {
    refuse(place + ".inertia_com",
           "above 0 about the line from the hinge to the centre of mass, "
           "where bodies hang on bodies or masses change");
  }
}

}  // namespace

Matrix3d checked_rotation(const Matrix3d& matrix, const std::string& place) {
  const double error = (matrix.transpose() * matrix - Matrix3d::Identity())
                           .cwiseAbs()
                           .maxCoeff();
  // Seven printed digits pass.
  if (!(error <= 1e-6) || matrix.determinant() < 0) {
    refuse(place, "a rotation matrix (orthogonal to 1e-6, right-handed)");
  }
  return Eigen::Quaterniond(matrix).normalized().toRotationMatrix();
}

System::System(const Carrier& carrier, const std::vector<Body>& bodies)
    : carrier_(carrier) {
  if (carrier.fixed) {
    carrier_ = {.fixed = true};
  } else {
    check_mass(carrier.mass, "carrier");
    carrier_.inertia =
        checked_inertia(carrier.inertia, true, "carrier.inertia_com");
  }
  links_.reserve(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    links_.push_back(make_link(bodies[i], fmt::format("bodies[{}]", i)));
  }
  std::vector<int> parents;
  for (const Link& link : links_) parents.push_back(link.parent);
  order_ = parents_first(parents);
  is_star_ = !carrier.flows &&
             std::ranges::all_of(parents, [](int p) { return p < 0; }) &&
             std::ranges::none_of(bodies, &Body::flows);
  for (std::size_t i = 0; i < bodies.size() && !is_star_; ++i) {
    check_spin(links_[i], fmt::format("bodies[{}]", i));
  }
}

}  // namespace multibody
