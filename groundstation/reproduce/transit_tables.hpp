// What papers/004 says of its flights beside ours: Fig. 5, the volume that goes on air, Fig. 8 and Fig. 9.
//
// Medians are over the flights in which all planners of the table arrive.
// Source: papers/004, section IV. Departs from source: the buildings are ours, samples are lost, and there are more
// runs; each table says so. Complexity: O(flights log flights).
#pragma once

#include <vector>

#include "groundstation/reproduce/campaign.hpp"
#include "groundstation/reproduce/table.hpp"

namespace skein::reproduce {

/// Those for which anything was run, in the paper's order.
[[nodiscard]] std::vector<Table> transit_tables(const Results& results);

}  // namespace skein::reproduce
