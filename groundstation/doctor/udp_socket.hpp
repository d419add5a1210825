// A UDP socket over IPv4, closed with its owner, as the probes use it.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>

namespace skein::doctor {

class UdpSocket {
 public:
  UdpSocket() : fd_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {}
  ~UdpSocket() {
    if (fd_ >= 0) ::close(fd_);
  }
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;

  [[nodiscard]] int fd() const { return fd_; }
  /// On all addresses; port 0 takes any. False if it is held, or there is no such port.
  [[nodiscard]] bool bind(std::uint32_t port) const {
    if (fd_ < 0 || port > 65535) return false;
    const sockaddr_in address = address_of(INADDR_ANY, static_cast<std::uint16_t>(port));
    return ::bind(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  }
  template <typename Value>
  [[nodiscard]] bool set(int level, int option, const Value& value) const {
    return ::setsockopt(fd_, level, option, &value, sizeof(value)) == 0;
  }
  /// The port that it is bound to; 0 if it is not.
  [[nodiscard]] std::uint16_t port() const {
    sockaddr_in address{};
    socklen_t size = sizeof(address);
    return ::getsockname(fd_, reinterpret_cast<sockaddr*>(&address), &size) == 0 ? ntohs(address.sin_port)
                                                                                 : std::uint16_t{0};
  }
  [[nodiscard]] static sockaddr_in address_of(std::uint32_t host, std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(host);
    address.sin_port = htons(port);
    return address;
  }

 private:
  int fd_;
};

}  // namespace skein::doctor
