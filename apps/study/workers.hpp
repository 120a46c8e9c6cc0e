#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "study/rows/journal.hpp"
#include "study/study.hpp"

namespace study {

/// Computes rows in threads and stores each row in the journal when it is
/// complete.
/// @param stop  called during runs: the reason to end; unfinished rows are lost
/// @param done  called after each row, by one thread at a time
void compute(const Study& study, const std::vector<std::uint64_t>& runs,
             int jobs, Journal& journal,
             const std::function<std::string()>& stop,
             const std::function<void()>& done);

}  // namespace study
