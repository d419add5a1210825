// The tables of papers/001 beside ours: Tables 3, 4 and 6, its curves, and what it leaves open.
//
// Source: papers/001, section 4. Departs from source: the rendezvous point is (30, 15) km, not (35, 15), the obstacles
// are ours, and there are more runs; each table says so. Complexity: O(runs).
#pragma once

#include <vector>

#include "groundstation/reproduce/campaign.hpp"
#include "groundstation/reproduce/table.hpp"

namespace skein::reproduce {

/// Those for which anything was run, in the paper's order.
[[nodiscard]] std::vector<Table> rendezvous_tables(const Results& results);

}  // namespace skein::reproduce
