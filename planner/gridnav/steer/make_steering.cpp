#include <stdexcept>

#include "planner/gridnav/steer/peach.hpp"
#include "planner/gridnav/steer/peach3d.hpp"
#include "planner/gridnav/steer/peach3d_paper.hpp"
#include "planner/gridnav/steer/steering.hpp"

namespace skein::gridnav {

std::unique_ptr<Steering> make_steering(const Task& task, const Cell& start) {
  if (task.options.name == "peach3d") return std::make_unique<Peach3d>(task, start);
  if (task.options.name == "peach3d-paper") return std::make_unique<Peach3dPaper>(task);
  if (task.options.name == "peach") return std::make_unique<Peach>(task);
  throw std::invalid_argument("no transit planner is called '" + task.options.name + "'");
}

}  // namespace skein::gridnav
