// The orders and answers of a tick, between plain value and wire.
//
// Source: idl/msg/tick.idl. Departs from source: none. Complexity: linear.
#pragma once

#include <vector>

#include "idl/convert/checker.hpp"

namespace skein {

/// @throws std::invalid_argument if there are more than wire::kMaxOrders
[[nodiscard]] std::vector<wire::Ordered> wire_orders(const std::vector<Order>& orders);
[[nodiscard]] std::vector<wire::Answered> wire_answers(const std::vector<OrderAnswer>& answers);
void check_orders(Checker& check, const std::vector<wire::Ordered>& orders);
void check_answers(Checker& check, const std::vector<wire::Answered>& answers);
/// Of checked ones.
[[nodiscard]] std::vector<Order> plain_orders(const std::vector<wire::Ordered>& orders);
[[nodiscard]] std::vector<OrderAnswer> plain_answers(const std::vector<wire::Answered>& answers);

}  // namespace skein
