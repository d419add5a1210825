// What a person chose to see, and what each key does to it.
//
//   key            does                              key        does
//   n, p           next, previous agent              + -        zoom
//   f              follow the agent                  arrows     pan
//   v (1 2 3)      the next plane (x-y, x-z, y-z)    0          all in the picture
//   t              table of all figures              d w z c l  plans, trails, zones, cells, links
//   ?              all keys                          q          leave
// A pure function of state, key and view. Source: none needed. Departs from source: none. Complexity: O(agents).
#pragma once

#include <optional>

#include "groundstation/monitor/camera.hpp"
#include "groundstation/watch/view.hpp"

namespace skein::monitor {

/// A key: a character, or one of those without.
enum class Special : std::uint8_t { None, Up, Down, Left, Right };
struct Key {
  char character = 0;
  Special special = Special::None;
};

struct Choices {
  AgentId selected = 0;  ///< 0: the lowest
  Plane plane = Plane::XY;
  double zoom = 1.0;
  std::optional<Vec3> centre_m;  ///< where a person panned to; nothing: the middle of everything
  bool follow = false;
  bool table = false;  ///< the table takes the place of the map
  bool help = false;
  bool plans = true;
  bool trails = true;
  bool zones = true;
  bool cells = true;
  bool links = true;
  bool quit = false;
};

/// The agent that is selected, nothing if there is none.
[[nodiscard]] const watch::AgentView* selected_agent(const Choices& choices, const watch::SwarmView& view);

/// Where the camera looks.
[[nodiscard]] std::optional<Vec3> centre_of(const Choices& choices, const watch::SwarmView& view);

/// The choices after a key; one without meaning changes nothing.
[[nodiscard]] Choices after_key(Choices choices, const Key& key, const watch::SwarmView& view);

}  // namespace skein::monitor
