// From the samples of the in-memory bus to what a recording takes: the same bytes as DDS carries.
#pragma once

#include "groundstation/record/recording.hpp"
#include "idl/bus/memory_bus.hpp"
#include "idl/convert/cdr.hpp"

namespace skein {

[[nodiscard]] bus::TopicId topic_of(const wire::Sample& sample);
[[nodiscard]] Bytes payload_of(const wire::Sample& sample);

/// Hands on what is published.
[[nodiscard]] bus::Tap tap_into(TakeSample take);

}  // namespace skein
