// The own cost of one candidate path of any number of segments, in plain scalar code.
//
// Energies of the segments are summed; zones, curvature, torsion and terrain are checked at Np points of equal
// parameter distance on each segment, and between neighbouring points the chord against the zones; separation is to be
// checked at Nph points that are equidistant on the whole path.
//
// Source: papers/001, Eq. 11, 12 and Remark 4. Departs from source: see cost/cost.hpp.
// Complexity: O(segments Np (zones + Newton)).
#pragma once

#include "planner/rendezvous/cost/cost.hpp"

namespace skein::rendezvous {

/// Fills `into` for controls within the search range: terms of Eq. 11; collision and dtime 0, modified = own.
template <typename Space>
void evaluate_scalar(const ProblemIn<Space>& problem, const ph::Controls& controls, EvaluationIn<Space>& into);

}  // namespace skein::rendezvous
