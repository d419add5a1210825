// What is known of a swarm as JSON and as lines of text: `skein status` and `skein topics` (docs/monitor.md).
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "groundstation/watch/view.hpp"

namespace skein::watch {

/// The whole swarm: run, agents, events, topics. What is not known is null.
[[nodiscard]] nlohmann::ordered_json status_json(const SwarmView& view, const std::string& swarm);
/// A table of the agents under a line on the run; `events` of the last ones below.
[[nodiscard]] std::string status_text(const SwarmView& view, const std::string& swarm, std::size_t events);

[[nodiscard]] nlohmann::ordered_json topics_json(const SwarmView& view, const std::string& swarm);
[[nodiscard]] std::string topics_text(const SwarmView& view);

/// One line about an event: when, who, what, why.
[[nodiscard]] std::string event_text(const Event& event);

}  // namespace skein::watch
