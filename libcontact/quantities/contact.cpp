#include "libcontact/joint/presliding/stiction.hpp"
#include "libcontact/quantities/tables.hpp"

namespace contact {
namespace {

using Patch = ContactPatch;

bool has_half_angle(const Patch& p) { return !std::isnan(p.half_angle); }
bool has_interference(const Patch& p) { return p.contact.has_interference(); }
double stiction(const Patch& p) {
  return stiction_deformation(p.contact, p.normal_force, p.half_angle);
}
bool has_stiction(const Patch& p) { return !std::isnan(stiction(p)); }

constexpr Quantity<Patch> of_patch[] = {
    {"half_angle", "theta0", Dimension::angle, "half-angle of the contact",
     [](const Patch& p) { return p.half_angle; }, "", has_half_angle},
    {"load_parameter", "", Dimension::number, "mu of a ball, lambda of a pin",
     [](const Patch& p) { return p.contact.load_parameter(p.normal_force); }},
    {"peak_pressure", "p_peak", Dimension::stress, "peak pressure",
     [](const Patch& p) {
       return p.contact.peak_pressure(p.normal_force, p.half_angle);
     },
     "", has_half_angle},
    {"mean_pressure", "p_mean", Dimension::stress,
     "mean pressure over the contact's own area",
     [](const Patch& p) {
       return p.contact.mean_pressure(p.normal_force, p.half_angle);
     },
     "", has_half_angle},
    {"nominal_pressure", "p_nominal", Dimension::stress,
     "force over the area of catalogues: pi rho^2 of a ball, of a seat that "
     "is a ring ball diameter times its width, 2 rho l of a pin",
     [](const Patch& p) {
       return p.contact.geometry().nominal_pressure(p.normal_force);
     }},
    {"contact_area", "", Dimension::area, "area of the contact",
     [](const Patch& p) { return p.contact.area(p.half_angle); }, "",
     has_half_angle},
    // The rows of presliding_quantities().
    {"presliding_angle", "", Dimension::angle,
     "turn before sliding, f0 D/rho; lined seats 1.2 to 4 times",
     [](const Patch& p) { return stiction(p) / p.contact.geometry().radius(); },
     "", has_stiction},
    {"stiction_deformation", "", Dimension::length,
     "slip before sliding, f0 D; lined seats 1.2 to 4 times",
     [](const Patch& p) { return stiction(p); }, "", has_stiction},
    // From here on the rows of preload_quantities().
    {"interference_pressure", "p_0", Dimension::stress,
     "pressure of interference alone, uniform all round",
     [](const Patch& p) { return p.contact.interference_pressure(); }, "",
     has_interference},
    {"lift_off_force", "R_lift_off", Dimension::force,
     "normal force above which a contact with interference opens",
     [](const Patch& p) { return p.contact.lift_off_force(); }, "",
     has_interference},
    {"unloaded_moment", "M_0", Dimension::moment,
     "friction moment at which interference alone breaks away",
     [](const Patch& p) { return p.contact.unloaded_moment(0); }, "",
     has_interference},
    {"sum_of_pressures", "sum_p", Dimension::force,
     "sum of the pressures without regard to their direction",
     [](const Patch& p) {
       return p.contact.sum_of_pressures(p.normal_force, p.half_angle);
     },
     "", has_half_angle},
    {"shift", "", Dimension::length,
     "shift of the centres of the two bodies from the concentric position",
     [](const Patch& p) {
       return p.contact.shift(p.normal_force, p.half_angle);
     },
     "", has_half_angle},
};

constexpr Quantity<ContactApproach> of_approach[] = {
    {"approach", "", Dimension::length,
     "approach of the two bodies from first touch",
     [](const ContactApproach& a) { return a.approach; }},
    {"stiffness", "", Dimension::line_force, "d R_n/d approach",
     [](const ContactApproach& a) { return a.stiffness; }},
};

constexpr Quantity<FrictionTriple> of_coefficients[] = {
    {"force", "chi", Dimension::number, "friction force over f0 R_n",
     [](const FrictionTriple& c) { return c.force; }},
    {"sliding", "sigma_Y", Dimension::number, "sliding moment over f0 rho R_n",
     [](const FrictionTriple& c) { return c.sliding; }},
    {"spinning", "sigma_Z", Dimension::number,
     "spinning moment over f0 rho R_n",
     [](const FrictionTriple& c) { return c.spinning; }},
};

// A coefficient among the integrals it is made of.
constexpr Quantity<FrictionIntegrals> coefficient(
    std::string_view key, const Quantity<FrictionTriple>& of,
    double (*get)(const FrictionIntegrals&)) {
  return {key, of.symbol, of.dimension, of.meaning, get};
}

using Integrals = FrictionIntegrals;

constexpr Quantity<Integrals> of_integrals[] = {
    {"normal", "I_normal", Dimension::number,
     "normal integral, R_n = rho^2 p(0) I_normal",
     [](const Integrals& i) { return i.normal; }},
    {"pressure_force", "I_p", Dimension::number,
     "friction force, weighted with p/p(0)",
     [](const Integrals& i) { return i.pressure.force; }},
    {"pressure_sliding", "J_p", Dimension::number,
     "sliding moment, weighted with p/p(0)",
     [](const Integrals& i) { return i.pressure.sliding; }},
    {"pressure_spinning", "K_p", Dimension::number,
     "spinning moment, weighted with p/p(0)",
     [](const Integrals& i) { return i.pressure.spinning; }},
    {"area_force", "I_a", Dimension::number,
     "friction force, weighted with 1 (adhesion)",
     [](const Integrals& i) { return i.area.force; }},
    {"area_sliding", "J_a", Dimension::number,
     "sliding moment, weighted with 1",
     [](const Integrals& i) { return i.area.sliding; }},
    {"area_spinning", "K_a", Dimension::number,
     "spinning moment, weighted with 1",
     [](const Integrals& i) { return i.area.spinning; }},
    coefficient("force", of_coefficients[0],
                [](const Integrals& i) { return i.coefficient.force; }),
    coefficient("sliding", of_coefficients[1],
                [](const Integrals& i) { return i.coefficient.sliding; }),
    coefficient("spinning", of_coefficients[2],
                [](const Integrals& i) { return i.coefficient.spinning; }),
};

bool slides(const SlidingContact::Rating& r) { return r.slides; }

using Rating = SlidingContact::Rating;

constexpr Quantity<Rating> of_rating[] = {
    {"pv_max", "", Dimension::power_density, "largest p v over the contact",
     [](const Rating& r) { return r.pv.value; }},
    {"pv_max_theta", "", Dimension::angle,
     "its angle from the centre of the contact",
     [](const Rating& r) { return r.pv.theta; }, "", slides},
    {"pv_max_place", "pv_max", Dimension::number,
     "its direction from the joint's centre",
     [](const Rating& r) -> const Eigen::Vector3d& { return r.pv.place; }, "",
     slides},
    {"pv_mean", "", Dimension::power_density, "mean p v over the contact",
     [](const Rating& r) { return r.pv_mean; }},
    {"pv_nominal", "", Dimension::power_density,
     "p_nominal times rho |Dw|: PV as in catalogues",
     [](const Rating& r) { return r.pv_nominal; }},
    {"nominal_area", "", Dimension::area,
     "area of p_nominal: pi rho^2, diameter times width of a ring, or 2 rho L",
     [](const Rating& r) { return r.nominal_area; }},
    {"pv_total", "", Dimension::power, "integral of p v over the contact",
     [](const Rating& r) { return r.pv_total; }},
    {"heat_flux_max", "q_max", Dimension::power_density,
     "largest heat flux of friction, into both bodies",
     [](const Rating& r) { return r.heat_flux.value; }},
    {"heat_flux_max_theta", "q_max_theta", Dimension::angle,
     "its angle from the centre of the contact",
     [](const Rating& r) { return r.heat_flux.theta; }, "", slides},
    {"heat_flux_max_place", "q_max", Dimension::number,
     "its direction from the joint's centre",
     [](const Rating& r) -> const Eigen::Vector3d& {
       return r.heat_flux.place;
     },
     "", slides},
    {"heat", "", Dimension::power, "heat of friction over the contact",
     [](const Rating& r) { return r.heat; }},
    {"slip_coefficient", "", Dimension::number,
     "L: all p v is rho |Dw| R_n L; none of pins that slide along their axis "
     "alone",
     [](const Rating& r) { return r.slip_coefficient; }, "", slides},
};

}  // namespace

std::span<const Quantity<ContactPatch>> patch_quantities() { return of_patch; }

std::span<const Quantity<ContactPatch>> preload_quantities() {
  constexpr std::size_t count = 5;
  return std::span(of_patch).last<count>();
}

std::span<const Quantity<ContactPatch>> presliding_quantities() {
  return patch_quantities().subspan(
      std::size(of_patch) - preload_quantities().size() - 2, 2);
}

std::span<const Quantity<ContactApproach>> approach_quantities() {
  return of_approach;
}

std::span<const Quantity<FrictionTriple>> coefficient_quantities() {
  return of_coefficients;
}

std::span<const Quantity<FrictionIntegrals>> integral_quantities() {
  return of_integrals;
}

std::span<const Quantity<SlidingContact::Rating>> rating_quantities() {
  return of_rating;
}

}  // namespace contact
