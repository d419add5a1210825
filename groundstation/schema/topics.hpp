// The schema of each topic of the bus. Complexity: the text is parsed once, at the first question.
#pragma once

#include "groundstation/schema/idl.hpp"
#include "idl/bus/topics.hpp"

namespace skein::schema {

/// The IDL that is embedded for the topic's type.
[[nodiscard]] std::string_view idl_of(bus::TopicId topic);

/// The topic's type.
[[nodiscard]] const Struct& type_of(bus::TopicId topic);

/// By name ("skein/tick"); nullptr for any other.
[[nodiscard]] const bus::TopicSpec* topic_named(std::string_view name);

}  // namespace skein::schema
