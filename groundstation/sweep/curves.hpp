// The curves of a run as plain CSV files, from which figures are drawn (deploy/figures.sh).
//
//   <stem>-paths.csv        vehicle, arc_m, x_m, y_m, z_m, ground_m, curvature_per_m, torsion_per_m,
//                           max_curvature_per_m, max_torsion_per_m: 201 points of each planned path at equal arc
//                           distances; ground_m is empty without terrain
//   <stem>-convergence.csv  vehicle, round, generation, cost, path_length_m: what each planner published in each
//                           planning round; cost is the modified one (Eq. 14, own cost without cooperation), in the
//                           mission's length units
//   <stem>-positions.csv    of a transit, instead of both: vehicle, step, x_m, y_m, z_m: where each vehicle was at
//                           the end of each flight step; step 0 is its start
//   <stem>-zones.csv        zone, no_fly, x_m, y_m, z_min_m, z_max_m, hidden: the outline of each zone from above,
//                           closed; of a mesh its bounding box, of the ground none. Hidden: agents are not told of it
// Complexity: O(vehicles x (points + rounds + steps)).
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "groundstation/inprocess/in_process.hpp"

namespace skein {

/// A file or folder that cannot be written; what() is one line.
struct CurvesNotWritten : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Where the files of one run go.
struct CurveFiles {
  std::filesystem::path folder;
  std::string stem;
};

/// The files of a sweep's row, counted from 0: "3-dcpso" is the third. Characters other than letters, digits and
/// `=.+-_` become '_'.
[[nodiscard]] CurveFiles curve_files(const std::filesystem::path& folder, std::size_t row, const std::string& title);

/// Makes the folder if need be, and writes the zones. @throws CurvesNotWritten
void write_zones(const Scenario& scenario, const CurveFiles& files);

/// The run of the scenario, as run_in_process without options, and its paths and convergence, or positions, written
/// when it has ended. A vehicle that published no plan has no path. @throws CurvesNotWritten
[[nodiscard]] InProcessResult run_with_curves(const Scenario& scenario, const CurveFiles& files);

}  // namespace skein
