// What the doctor makes of a machine's figures, one limit after the other.
#include "groundstation/doctor/findings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "groundstation/doctor/ports.hpp"

namespace skein::doctor {
namespace {

constexpr std::uint64_t kMega = 1024 * 1024;

/// A machine on which nothing is wrong.
MachineFigures healthy() {
  MachineFigures machine;
  machine.multicast_heard = {"lo", "eth0"};
  machine.discovery_port = true;
  machine.free_port_pairs = 250;
  machine.receive_buffer_bytes = machine.send_buffer_bytes = kBufferAsked_bytes;
  machine.descriptors = machine.descriptors_most = 1024;
  machine.memory_bytes = 8192 * kMega;
  machine.shm_bytes = 1024 * kMega;
  machine.cores = 8;
  return machine;
}

Finding finding_of(const MachineFigures& machine, const Swarm& swarm, const std::string& what) {
  const auto findings = findings_of(machine, swarm);
  const auto found = std::ranges::find(findings, what, &Finding::what);
  EXPECT_NE(found, findings.end()) << what;
  return found == findings.end() ? Finding{} : *found;
}

TEST(Findings, OfAHealthyMachineAreAllOkAndNeedNoRemedy) {
  for (const bool shared_memory : {false, true}) {
    const auto findings = findings_of(healthy(), {50, 7, shared_memory});
    EXPECT_EQ(findings.size(), 9U);
    for (const Finding& finding : findings) {
      EXPECT_EQ(finding.level, Level::Ok) << finding.what << ": " << finding.figure;
      EXPECT_FALSE(finding.figure.empty()) << finding.what;
      EXPECT_TRUE(finding.remedy.empty()) << finding.what;
    }
    EXPECT_TRUE(can_run(findings));
  }
}

struct Case {
  const char* what;
  Level level;
  Swarm swarm;
  std::function<void(MachineFigures&)> change;
  const char* figure;  ///< part of it
  const char* remedy;  ///< likewise
};

TEST(Findings, NameTheLimitTheFigureAndTheRemedy) {
  const std::vector<Case> cases{
      {"multicast", Level::Fail, {3}, [](auto& m) { m.multicast_heard.clear(); }, "heard on none", "239.255.0.0/16"},
      {"discovery port", Level::Fail, {3, 2}, [](auto& m) { m.discovery_port = false; }, "UDP 7900", "--domain"},
      {"ports",
       Level::Fail,
       {12, 2},
       [](auto& m) { m.free_port_pairs = 12; },
       "12 pairs of UDP ports free in domain 2",
       "--domain"},
      {"ports", Level::Warn, {120, 2}, [](auto&) {}, "121 needed", "domain 3"},
      {"receive buffer",
       Level::Warn,
       {13},
       [](auto& m) { m.receive_buffer_bytes = 212992; },
       "0.20 MB",
       "net.core.rmem_max=4194304"},
      {"send buffer",
       Level::Warn,
       {13},
       [](auto& m) { m.send_buffer_bytes = 212992; },
       "0.20 MB",
       "net.core.wmem_max=4194304"},
      {"receive buffer", Level::Fail, {2}, [](auto& m) { m.receive_buffer_bytes = 65535; }, "0.06 MB", "rmem_max"},
      {"send buffer", Level::Fail, {2}, [](auto& m) { m.send_buffer_bytes = 0; }, "0.00 MB", "wmem_max"},
      {"descriptors", Level::Fail, {2}, [](auto& m) { m.descriptors = 63; }, "63 for each process", "ulimit -n 64"},
      {"descriptors", Level::Fail, {2}, [](auto& m) { m.descriptors = m.descriptors_most = 32; }, "32", "limits.conf"},
      {"memory", Level::Fail, {50}, [](auto& m) { m.memory_bytes = 500 * kMega; }, "about 517 MB needed", "fewer"},
      {"memory", Level::Warn, {50}, [](auto& m) { m.memory_bytes = 1000 * kMega; }, "1000 MB", "twice"},
      {"cores", Level::Warn, {60}, [](auto& m) { m.cores = 2; }, "13.4 s until 61 processes", "--startup-timeout"},
      {"cores", Level::Fail, {100}, [](auto& m) { m.cores = 2; }, "36.7 s", "fewer agents"},
      {"cores", Level::Warn, {50}, [](auto& m) { m.cores = 2, m.receive_buffer_bytes = 212992; }, "18.7 s", "120"},
      {"/dev/shm", Level::Fail, {9, 0, true}, [](auto& m) { m.shm_bytes = 6 * kMega; }, "6.4 MB needed", "clean"},
      {"/dev/shm", Level::Warn, {9, 0, true}, [](auto& m) { m.shm_left_behind = 8; }, "8 files", "clean"},
  };
  for (const Case& test : cases) {
    MachineFigures machine = healthy();
    test.change(machine);
    const Finding finding = finding_of(machine, test.swarm, test.what);
    EXPECT_EQ(finding.level, test.level) << test.what << ": " << finding.figure;
    EXPECT_NE(finding.figure.find(test.figure), std::string::npos) << test.what << ": " << finding.figure;
    EXPECT_NE(finding.remedy.find(test.remedy), std::string::npos) << test.what << ": " << finding.remedy;
    EXPECT_EQ(finding.remedy.find('\n'), std::string::npos) << test.what;
    EXPECT_EQ(can_run(findings_of(machine, test.swarm)), test.level != Level::Fail) << test.what;
  }
}

TEST(Findings, DebiansOwnBuffersAreEnoughForADozen) {
  MachineFigures machine = healthy();
  machine.receive_buffer_bytes = machine.send_buffer_bytes = 212992;
  EXPECT_EQ(finding_of(machine, {12}, "receive buffer").level, Level::Ok);
  EXPECT_EQ(finding_of(machine, {12}, "send buffer").level, Level::Ok);
}

TEST(Findings, WithoutSharedMemoryItDoesNotMatter) {
  MachineFigures machine = healthy();
  machine.shm_bytes = 0;
  machine.shm_left_behind = 100;
  EXPECT_EQ(finding_of(machine, {50}, "/dev/shm").level, Level::Ok);
}

TEST(Ports, AreThoseOfTheStandard) {
  EXPECT_EQ(discovery_port_of(0), 7400U);
  EXPECT_EQ(own_port_of(0, 0), 7410U);
  EXPECT_EQ(own_port_of(3, 2), 7410U + 750U + 4U);
  EXPECT_EQ(own_port_of(5, kOwnPairs), discovery_port_of(6));
  EXPECT_EQ(pairs_of(0), 250U);
  EXPECT_EQ(pairs_of(232), 63U);
  EXPECT_EQ(own_port_of(232, 62) + 1, 65535U);
}

}  // namespace
}  // namespace skein::doctor
