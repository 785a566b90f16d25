#include "experiment/link/packet_line.h"

#include <unistd.h>

#include <algorithm>
#include <array>

namespace experiment {
namespace {

constexpr std::size_t kLargest = 65536;  // IPv4 has no larger packet

suture::FaultPlan planOf(const PacketFate& fate) {
  return {.seed = fate.seed, .loss = fate.loss, .jitter = fate.jitter};
}

}  // namespace

PacketLine::PacketLine(int from, int to, const PacketFate& fate, std::uint32_t stream)
    : from_(from), to_(to), way_(fate.way), faults_(planOf(fate), stream) {}

void PacketLine::take() {
  std::array<std::uint8_t, kLargest> bytes;
  for (;;) {
    const ssize_t size = ::read(from_, bytes.data(), bytes.size());
    if (size <= 0) return;
    const suture::Fate fate = faults_.next();
    ++counts_.taken;
    if (fate.lost) {
      ++counts_.lost;
      continue;
    }
    lastDue_ = std::max(lastDue_, suture::now() + way_ + fate.later);
    underWay_.push_back({lastDue_, {bytes.data(), bytes.data() + size}});
  }
}

void PacketLine::deliver(suture::Time now) {
  while (!underWay_.empty() && underWay_.front().due <= now) {
    const auto& bytes = underWay_.front().bytes;
    // The receiver's kernel drops what it has no room for, as a network does.
    [[maybe_unused]] const ssize_t written = ::write(to_, bytes.data(), bytes.size());
    underWay_.pop_front();
    ++counts_.delivered;
  }
}

suture::Time PacketLine::next() const {
  return underWay_.empty() ? suture::Time::max() : underWay_.front().due;
}

}  // namespace experiment
