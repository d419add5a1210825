#include "idl/bus/dds_port.hpp"

namespace skein::bus {

DdsAgentPort::DdsAgentPort(const DdsConfig& config) : group_(config, {&config.id, 1}) {}
DdsAgentPort::~DdsAgentPort() = default;

void DdsAgentPort::publish(const AgentOutbound& sample) {
  group_.port(0).publish(sample);
}

void DdsAgentPort::take(std::vector<AgentInbound>& into) {
  group_.port(0).take(into);
}

void DdsAgentPort::wake_after(std::size_t samples) {
  group_.port(0).wake_after(samples);
}

std::vector<std::uint64_t> DdsAgentPort::matched() const {
  return group_.port(0).matched();
}

}  // namespace skein::bus
