#include "idl/process/poll.hpp"

#include <poll.h>

#include <array>
#include <chrono>
#include <cmath>

namespace skein {

double steady_now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void wait_readable(std::initializer_list<int> descriptors, double timeout_s) {
  std::array<pollfd, 8> set{};
  nfds_t count = 0;
  for (const int descriptor : descriptors) {
    if (descriptor >= 0 && count < set.size()) set[count++] = {descriptor, POLLIN, 0};
  }
  poll(set.data(), count, static_cast<int>(std::ceil(timeout_s * 1000.0)));
}

}  // namespace skein
