#include "groundstation/record/bus_recorder.hpp"

#include <algorithm>

namespace skein {

std::size_t BusRecorder::take() {
  arrived_.clear();
  port_.take(arrived_);
  for (const bus::RawSample& sample : arrived_) {
    Process process{};
    std::copy_n(sample.writer.begin(), process.size(), process.begin());
    const bool is_worlds = sample.topic == bus::TopicId::Mission || sample.topic == bus::TopicId::Tick;
    if (is_worlds) worlds_.insert(process);
    const bool from_world = is_worlds || sample.topic == bus::TopicId::Sense || worlds_.contains(process);
    heard_tick_ = heard_tick_ || sample.topic == bus::TopicId::Tick;
    const auto head = head_of(sample.topic, sample.payload);
    gaps_.note(sample, from_world, head ? head->agent : kWorldId);
    ends_.note(sample, from_world);
    rounds_.note(sample.topic, sample.payload);
    record_({sample.topic, from_world, sample.sequence, sample.payload});
  }
  return arrived_.size();
}

}  // namespace skein
