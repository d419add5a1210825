// What decides a round, as bytes of a journal and back.
//
// Little-endian numbers, doubles by bit pattern, lists after their length; of each answer the CDR bytes of its wire
// structs (idl/convert), read back through the same checks as a sample that arrives. Source: own. Departs from source:
// none. Complexity: linear in the answers.
#pragma once

#include <optional>
#include <span>

#include "idl/convert/cdr.hpp"
#include "idl/convert/convert.hpp"
#include "simworld/lockstep/recorder.hpp"

namespace skein {

[[nodiscard]] Bytes to_bytes(const RoundInputs& inputs);

/// Nothing if the bytes are not what to_bytes() gives, or an answer is refused. @param context of the answers: run, ids
/// and grid of the mission
[[nodiscard]] std::optional<RoundInputs> round_inputs_from(std::span<const std::uint8_t> bytes,
                                                           const WireContext& context);

}  // namespace skein
