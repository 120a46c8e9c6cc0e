#include "programs/separation/replay/replay.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace separation {

std::vector<Take> takes_of(const Replay& replay, int every) {
  std::vector<Take> takes;
  for (const ShownRun& run : replay.runs) {
    const Rows& rows = run.outcome->memory.rows;
    takes.push_back({run.of != nullptr ? run.of : &replay.c, run.name,
                     !takes.empty(), &rows, replay_rows(rows, every)});
  }
  return takes;
}

std::string replay_glb(const Replay& replay) {
  return make_scene(takes_of(replay, 1), 1).glb;
}

std::vector<std::string> replay_faults(const Replay& replay) {
  std::vector<std::string> faults;
  auto names = shapeless(replay.c);
  constexpr std::size_t most = 6;
  if (names.size() > most) {
    const std::size_t more = names.size() - most + 1;
    names.resize(most - 1);
    names.push_back(fmt::format("{} more", more));
  }
  if (!names.empty()) {
    faults.push_back(fmt::format("bodies without shapes are shown as axes: {}",
                                 fmt::join(names, ", ")));
  }
  const Take take = takes_of(replay, 1).front();
  for (int i = 0; i <= static_cast<int>(replay.c.bodies.size()); ++i) {
    constexpr double far = 1;  // rad
    const double turn =
        BodyPath(replay.c, *take.rows, take.kept, i).largest_turn();
    if (!(turn > far)) continue;
    faults.push_back(
        fmt::format("{} turns by up to {:.2g} rad between two rows, too far to "
                    "interpolate the replay: use a shorter output_step",
                    replay.c.rigid_body(i).name, turn));
  }
  return faults;
}

}  // namespace separation
