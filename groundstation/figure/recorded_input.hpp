// What a recording holds to draw (docs/recording.md).
#pragma once

#include "groundstation/figure/input.hpp"

namespace skein::figure {

/// Up to where the file was cut or damaged; then `notes` says so. @throws std::runtime_error with one line if nothing
/// can be drawn of it
[[nodiscard]] RunInput input_of_recording(const std::string& path);

}  // namespace skein::figure
