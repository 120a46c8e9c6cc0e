#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "study/rows/journal.hpp"
#include "study/study.hpp"

namespace study {

/// Computes rows in threads; each is in the journal as soon as it is done.
/// @param stop  asked on the way: why to end; rows that are under way are lost
/// @param done  called after each row, by one thread at a time
void compute(const Study& study, const std::vector<std::uint64_t>& runs,
             int jobs, Journal& journal,
             const std::function<std::string()>& stop,
             const std::function<void()>& done);

}  // namespace study
