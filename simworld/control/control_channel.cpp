#include "simworld/control/control_channel.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <system_error>

namespace skein {

ControlChannel::ControlChannel(int descriptor) : descriptor_(descriptor) {
  if (descriptor_ >= 0) fcntl(descriptor_, F_SETFD, FD_CLOEXEC);
}

ControlChannel::~ControlChannel() {
  close();
}

void ControlChannel::close() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

std::pair<ControlChannel, ControlChannel> ControlChannel::pair() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends.data()) != 0) {
    throw std::system_error(errno, std::generic_category(), "socketpair");
  }
  std::pair<ControlChannel, ControlChannel> channels{ControlChannel(ends[0]), ControlChannel(ends[1])};
  fcntl(ends[1], F_SETFD, 0);
  return channels;
}

void ControlChannel::send(const nlohmann::json& message, bool may_drop) {
  if (!open()) return;
  const std::string text = message.dump();
  const int flags = MSG_NOSIGNAL | (may_drop ? MSG_DONTWAIT : 0);
  const ssize_t sent = ::send(descriptor_, text.data(), text.size(), flags);
  if (sent < 0 && errno != EAGAIN && errno != EINTR) close();
}

std::optional<nlohmann::json> ControlChannel::receive() {
  if (!open()) return std::nullopt;
  std::array<char, 4096> buffer{};
  const ssize_t size = recv(descriptor_, buffer.data(), buffer.size(), MSG_DONTWAIT);
  if (size > 0) {
    auto message = nlohmann::json::parse(buffer.data(), buffer.data() + size, nullptr, false);
    return message.is_object() ? std::optional(std::move(message)) : std::nullopt;
  }
  if (size == 0 || (errno != EAGAIN && errno != EINTR)) close();
  return std::nullopt;
}

}  // namespace skein
