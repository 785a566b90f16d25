#include "experiment/link/packet_line.h"

#include <unistd.h>

#include <algorithm>
#include <array>

namespace experiment {
namespace {

constexpr std::size_t kLargest = 65536;  // of IPv4

std::mt19937_64 randomOf(std::uint64_t seed, std::uint32_t stream) {
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                         stream};
  return std::mt19937_64(sequence);
}

suture::Duration shareOf(suture::Duration whole, double share) {
  return suture::Duration(static_cast<std::int64_t>(static_cast<double>(whole.count()) * share));
}

}  // namespace

PacketLine::PacketLine(int from, int to, const PacketFate& fate, std::uint32_t stream)
    : from_(from), to_(to), fate_(fate), random_(randomOf(fate.seed, stream)) {}

double PacketLine::draw() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

// This draws as many numbers for a lost packet as for any other, so that what befalls one does not
// change the next.
void PacketLine::take() {
  std::array<std::uint8_t, kLargest> bytes;
  for (;;) {
    const ssize_t size = ::read(from_, bytes.data(), bytes.size());
    if (size <= 0) return;
    const bool lost = draw() < fate_.loss;
    const suture::Duration later = shareOf(fate_.jitter, draw());
    ++counts_.taken;
    if (lost) {
      ++counts_.lost;
      continue;
    }
    lastDue_ = std::max(lastDue_, suture::now() + fate_.way + later);
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
