#pragma once

#include "libcontact/base/units.hpp"
#include "libcontact/duty/wear_in.hpp"

namespace hinge_duty {

/// What wear_in() says at some time.
struct WornQuantity {
  const char* name;
  double (*of)(const contact::WearIn::State&);
  const char* meaning;
};
inline constexpr WornQuantity worn_quantities[] = {
    {"cycles", [](const contact::WearIn::State& w) { return w.cycles; },
     "after them"},
    {"wear_number",
     [](const contact::WearIn::State& w) { return w.wear_number; },
     "volume over pi rho^2 eps, of a pin 2 rho eps l"},
    {"volume_seat_mm3",
     [](const contact::WearIn::State& w) { return 1e9 * w.volume; },
     "worn off; reliable"},
    {"penetration_mm",
     [](const contact::WearIn::State& w) { return 1e3 * w.penetration; },
     "deepest wear, to 8 %, once most of it is wear; no creep"},
    {"theta0_deg",
     [](const contact::WearIn::State& w) {
       return w.half_angle / contact::degree;
     },
     "largest, to 1.1 deg"},
    {"p_peak_Pa",
     [](const contact::WearIn::State& w) { return w.peak_pressure; },
     "largest, to 6 %, of a ball much worn up to 17 % too high"},
    {"pv_max_W_per_m2", [](const contact::WearIn::State& w) { return w.pv; },
     "largest, as p_peak"},
    {"energy_J", [](const contact::WearIn::State& w) { return w.energy; },
     "of a cycle"},
    {"mean_M_t_N_m",
     [](const contact::WearIn::State& w) { return w.mean_moment; },
     "mean of the friction moment"},
    {"worn_share", [](const contact::WearIn::State& w) { return w.worn_share; },
     "of p ~ cos theta in the pressure; the rest is that of the joint"},
};

}  // namespace hinge_duty
