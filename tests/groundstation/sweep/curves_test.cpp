// The curves that a sweep leaves in files, held to the report of the same run.
#include "groundstation/sweep/curves.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "groundstation/sweep/sweep.hpp"

namespace skein {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPoints = 201;

class Folder {
 public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "skein-curves-").string() + std::string(6, 'X');
    path_ = mkdtemp(pattern.data());
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// The rows of a file by column name; an empty field is NaN.
std::vector<std::map<std::string, double>> rows_of(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  std::vector<std::string> names;
  std::getline(file, line);
  for (std::istringstream header(line); std::getline(header, line, ',');) names.push_back(line);
  std::vector<std::map<std::string, double>> rows;
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    auto& row = rows.emplace_back();
    for (const std::string& name : names) {
      std::string field;
      std::getline(fields, field, ',');
      row[name] = field.empty() ? std::nan("") : std::stod(field);
    }
  }
  return rows;
}

SweepPlan plan_of(const std::string& scenario, const fs::path& curves) {
  SweepPlan plan;
  plan.scenario = SKEIN_SOURCE_DIR "/" + scenario;
  plan.first_seed = 1;
  plan.runs = 2;
  plan.curves = curves;
  return plan;
}

/// Of each vehicle: the arc ends at the planned length, the chords are no longer and hardly shorter than the arc, and
/// no point bends or winds more than it may.
void expect_paths(const fs::path& path, const nlohmann::ordered_json& figures, std::size_t vehicles) {
  const auto rows = rows_of(path);
  ASSERT_EQ(rows.size(), vehicles * kPoints) << path;
  for (std::size_t v = 0; v < vehicles; ++v) {
    double chords_m = 0.0;
    for (std::size_t k = v * kPoints; k < (v + 1) * kPoints; ++k) {
      EXPECT_LT(std::fabs(rows[k].at("curvature_per_m")), rows[k].at("max_curvature_per_m"));
      EXPECT_LT(std::fabs(rows[k].at("torsion_per_m")), rows[k].at("max_torsion_per_m"));
      if (k == v * kPoints) continue;
      chords_m += std::hypot(rows[k].at("x_m") - rows[k - 1].at("x_m"), rows[k].at("y_m") - rows[k - 1].at("y_m"),
                             rows[k].at("z_m") - rows[k - 1].at("z_m"));
    }
    const auto& last = rows[(v + 1) * kPoints - 1];
    const std::string id = std::to_string(static_cast<int>(last.at("vehicle")));
    const double planned_m = figures.at("vehicles." + id + ".planned_length_m");
    EXPECT_NEAR(last.at("arc_m"), planned_m, 1e-6);
    EXPECT_LE(chords_m, planned_m * (1.0 + 1e-12));
    EXPECT_NEAR(chords_m, planned_m, 1e-3 * planned_m);
  }
}

TEST(Curves, OfThePlaneAgreeWithTheReport) {
  const Folder folder;
  SweepPlan plan = plan_of("deploy/scenarios/rendezvous-2d.yaml", folder.path() / "new/one");
  plan.keys = {{"planner.name", {"dcpso", "dcpso-solo"}}};
  const SweepResult result = run_sweep(plan);
  ASSERT_EQ(result.rows.size(), 2U);
  const std::vector<std::string> stems{"1-dcpso", "2-dcpso-solo"};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& figures = result.rows[i].at("per_run")[0].at("figures");
    expect_paths(plan.curves + "/" + stems[i] + "-paths.csv", figures, 3);
    const auto rounds = rows_of(plan.curves + "/" + stems[i] + "-convergence.csv");
    ASSERT_EQ(rounds.size(), 3 * figures.at("rounds").get<std::size_t>());
    for (std::size_t v = 0; v < 3; ++v) {
      EXPECT_EQ(rounds[v].at("generation"), 0.0);
      const auto& last = rounds[rounds.size() - 3 + v];
      const std::string id = std::to_string(static_cast<int>(last.at("vehicle")));
      EXPECT_EQ(last.at("generation"), 50.0);
      EXPECT_EQ(last.at("path_length_m"), figures.at("vehicles." + id + ".planned_length_m"));
      EXPECT_GT(last.at("cost"), 0.5 * last.at("path_length_m") / 1000.0);  // w1 L and some energy
    }
  }
  // Without cooperation the best cost never rises.
  const auto alone = rows_of(plan.curves + "/2-dcpso-solo-convergence.csv");
  for (std::size_t i = 3; i < alone.size(); ++i) EXPECT_LE(alone[i].at("cost"), alone[i - 3].at("cost"));
  const auto zones = rows_of(plan.curves + "/1-dcpso-zones.csv");
  ASSERT_EQ(zones.size(), 2U * 73U + 2U * 5U);
  EXPECT_NEAR(std::hypot(zones[30].at("x_m") - 11000.0, zones[30].at("y_m") - 6000.0), 2000.0, 1e-9);
  EXPECT_EQ(zones[30].at("no_fly"), 0.0);
  EXPECT_EQ(zones.back().at("no_fly"), 1.0);
  EXPECT_EQ(zones.back().at("x_m"), 14000.0);
}

TEST(Curves, OfSpaceAgreeWithTheReport) {
  const Folder folder;
  const SweepPlan plan = plan_of("deploy/scenarios/rendezvous-3d.yaml", folder.path());
  const SweepResult result = run_sweep(plan);
  const std::string stem = plan.curves + "/1-as_in_the_scenario-";
  expect_paths(stem + "paths.csv", result.rows[0].at("per_run")[0].at("figures"), 3);
  double most_torsion_per_m = 0.0;
  for (const auto& row : rows_of(stem + "paths.csv")) {
    EXPECT_GT(row.at("z_m"), row.at("ground_m"));
    EXPECT_EQ(row.at("max_torsion_per_m"), 0.002);
    most_torsion_per_m = std::max(most_torsion_per_m, std::fabs(row.at("torsion_per_m")));
  }
  EXPECT_GT(most_torsion_per_m, 1e-4);
}

TEST(Curves, OfATransitAreThePositionsOfEveryStep) {
  const Folder folder;
  SweepPlan plan = plan_of("tests/data/small-transit.yaml", folder.path());
  plan.runs = 1;
  const auto figures = run_sweep(plan).rows[0].at("per_run")[0].at("figures");
  const std::string stem = plan.curves + "/1-as_in_the_scenario-";
  EXPECT_FALSE(fs::exists(stem + "paths.csv"));
  std::map<int, double> chords_m;
  std::map<int, std::map<std::string, double>> last;
  const auto rows = rows_of(stem + "positions.csv");
  for (const auto& row : rows) {
    const int id = static_cast<int>(row.at("vehicle"));
    if (last.contains(id)) {
      EXPECT_EQ(row.at("step"), last[id].at("step") + 1.0);
      chords_m[id] += std::hypot(row.at("x_m") - last[id].at("x_m"), row.at("y_m") - last[id].at("y_m"));
    } else {
      EXPECT_EQ(row.at("step"), 0.0);
    }
    last[id] = row;
  }
  EXPECT_EQ(chords_m.size(), 2U);
  for (const auto& [id, metres] : chords_m) {
    EXPECT_EQ(last[id].at("step"), figures.at("steps").get<double>());
    EXPECT_NEAR(metres, figures.at("vehicles." + std::to_string(id) + ".path_length_m"), 1e-6);
  }
  EXPECT_EQ(rows.size(), chords_m.size() * (figures.at("steps").get<std::size_t>() + 1));
  const auto corners = rows_of(stem + "zones.csv");
  EXPECT_EQ(corners.size(), 5U);
  for (const auto& corner : corners) EXPECT_EQ(corner.at("hidden"), 1.0);
}

TEST(Curves, ChangeNoResult) {
  const Folder folder;
  SweepPlan plan = plan_of("tests/data/small.yaml", folder.path());
  const auto traced = run_sweep(plan).rows[0].at("per_run");
  plan.curves.clear();
  const auto plain = run_sweep(plan).rows[0].at("per_run");
  ASSERT_EQ(traced.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(traced[i].at("state_hash"), plain[i].at("state_hash"));
}

TEST(Curves, AFolderThatCannotBeMadeIsOneLineBeforeTheFirstRun) {
  const Folder folder;
  std::ofstream(folder.path() / "file") << "not a folder";
  SweepPlan plan = plan_of("tests/data/small.yaml", folder.path() / "file/under");
  plan.on_progress = [](std::size_t, std::size_t) { ADD_FAILURE() << "a run took place"; };
  try {
    (void)run_sweep(plan);
    ADD_FAILURE() << "no exception";
  } catch (const CurvesNotWritten& error) {
    EXPECT_NE(std::string(error.what()).find("file/under"), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

TEST(Curves, FileNamesAreWithinTheFolder) {
  EXPECT_EQ(curve_files("d", 2, "../a b, key=[1,2]").stem, "3-.._a_b__key=_1_2_");
  EXPECT_LT(curve_files("d", 0, std::string(1000, 'x')).stem.size(), 200U);
}

}  // namespace
}  // namespace skein
