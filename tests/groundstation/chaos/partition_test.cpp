// Which ports are whose, and the rules that cut them off; that the rules act is for the e2e campaign to prove.
#include "groundstation/chaos/partition.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

namespace skein::chaos {
namespace {

/// A UDP socket of this process, on a port that the system chooses.
class Socket {
 public:
  Socket() : fd_(socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(bind(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  }
  ~Socket() { close(fd_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  [[nodiscard]] std::uint16_t port() const {
    sockaddr_in address{};
    socklen_t size = sizeof(address);
    EXPECT_EQ(getsockname(fd_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    return ntohs(address.sin_port);
  }

 private:
  int fd_;
};

TEST(Partition, PortsAreThoseThatTheProcessHasOpen) {
  const std::set<std::uint16_t> before = udp_ports_of(getpid());
  const Socket one;
  const Socket other;
  std::set<std::uint16_t> expected = before;
  expected.insert({one.port(), other.port()});
  EXPECT_EQ(udp_ports_of(getpid()), expected);
  EXPECT_TRUE(udp_ports_of(-1).empty()) << "of no process";
}

TEST(Partition, PortsOfBothSidesBelongToNeither) {
  const Socket one;
  EXPECT_TRUE(ports_of_one_side({getpid()}, {}).contains(one.port()));
  EXPECT_TRUE(ports_of_one_side({getpid()}, {getpid()}).empty());
}

TEST(Partition, RulesDropWhatCrossesAndNothingElse) {
  EXPECT_EQ(partition_rules({7410, 40000}),
            "*filter\n:INPUT ACCEPT [0:0]\n:SKEIN_FROM - [0:0]\n:SKEIN_TO - [0:0]\n-F INPUT\n"
            "-A INPUT -p udp --sport 7410 -j SKEIN_FROM\n-A INPUT -p udp --dport 7410 -j SKEIN_TO\n"
            "-A SKEIN_FROM -p udp --dport 7410 -j RETURN\n-A SKEIN_TO -p udp --sport 7410 -j RETURN\n"
            "-A INPUT -p udp --sport 40000 -j SKEIN_FROM\n-A INPUT -p udp --dport 40000 -j SKEIN_TO\n"
            "-A SKEIN_FROM -p udp --dport 40000 -j RETURN\n-A SKEIN_TO -p udp --sport 40000 -j RETURN\n"
            "-A SKEIN_FROM -j DROP\n-A SKEIN_TO -j DROP\nCOMMIT\n");
  EXPECT_EQ(partition_rules({}).find("-A INPUT"), std::string::npos) << "healed: nothing is looked at";
}

}  // namespace
}  // namespace skein::chaos
