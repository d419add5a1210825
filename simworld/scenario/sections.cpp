#include "simworld/scenario/sections.hpp"

namespace skein::scenario {

/// What is no kind at all is refused by the reader of a rendezvous, in its order.
Places read_sections(const YamlNode& root, std::optional<std::uint64_t> seed, Scenario& into) {
  const YamlNode* kind = root.kind == NodeKind::Map ? root.find("kind") : nullptr;
  const bool transit = kind != nullptr && kind->kind == NodeKind::Scalar && kind->text == "transit";
  return transit ? read_transit(root, seed, into) : read_rendezvous(root, seed, into);
}

}  // namespace skein::scenario
