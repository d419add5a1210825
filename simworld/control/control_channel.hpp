// The line between the launcher and the world: one JSON object a message over an inherited socket pair.
//
// world -> launcher:  {"launch": IDS}, {"kill": ID}, {"stop": ID}, {"cont": ID}, {"restart": ID}, {"progress": {...}}
// launcher -> world:  {"started": IDS, "pid": PID}, {"stopped": ID}, {"ended": IDS, "pid": PID, "status": STATUS}
//                     {"recorded": ROUND, "lacking": IDS}: what the recorder has of the round; {"unrecorded": REASON}
// IDS is the list of the agents of a process (of `launch`: of all that shall run); all of them end at once.
// Messages keep their boundaries (SOCK_SEQPACKET); both ends see it at once when the other is gone.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace skein {

class ControlChannel {
 public:
  /// Takes the descriptor over; a negative one is a channel that is closed from the start.
  explicit ControlChannel(int descriptor);
  ~ControlChannel();
  ControlChannel(ControlChannel&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  ControlChannel& operator=(ControlChannel&&) = delete;

  /// Two connected ends; the second one survives exec. @throws std::system_error
  [[nodiscard]] static std::pair<ControlChannel, ControlChannel> pair();

  [[nodiscard]] int fd() const { return descriptor_; }
  [[nodiscard]] bool open() const { return descriptor_ >= 0; }
  void close();
  /// Gives the descriptor up to the caller.
  [[nodiscard]] int release() { return std::exchange(descriptor_, -1); }

  /// Sends unless the other end is gone; `may_drop` messages are left out while the other end is slow.
  void send(const nlohmann::json& message, bool may_drop = false);
  /// The next message, or nothing; returns at once, and closes the channel if the other end is gone.
  [[nodiscard]] std::optional<nlohmann::json> receive();

 private:
  int descriptor_;
};

}  // namespace skein
