// The scenarios of the papers' experiments as texts, put into the program when it is built.
#pragma once

#include <string_view>

namespace skein::reproduce {

/// The text of deploy/scenarios/<name>.yaml, unchanged; empty if it is none of those that reproduce runs.
[[nodiscard]] std::string_view scenario_text(std::string_view name);

}  // namespace skein::reproduce
