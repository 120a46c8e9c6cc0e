#include "separation/case/force_kind.hpp"

namespace separation {

// Each has a file of its own beside this one.
ForceKind applied();
ForceKind thrust();
ForceKind spring();
ForceKind damper();
ForceKind pusher();
ForceKind motor();
ForceKind torsion();
ForceKind aerodynamic();

const std::vector<ForceKind>& force_kinds() {
  static const auto& kinds = *new std::vector<ForceKind>{
      applied(), thrust(), spring(),  damper(),
      pusher(),  motor(),  torsion(), aerodynamic()};
  return kinds;
}

}  // namespace separation
