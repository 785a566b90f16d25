#include "harness/clock.h"
#include "harness/figures.h"
#include "harness/measurements/measurements.h"

namespace peers {

void measureConversion(Peer& peer, const Options& options) {
  Pose sent, back;
  fill(sent, 7);
  const std::size_t bytes = peer.convert(sent, back);  // allocates what later conversions use
  bool same = sent == back;
  const std::int64_t begin = now();
  for (long i = 0; i < options.count; ++i) {
    sent.timestamp = sent.position[0] = static_cast<double>(i);
    peer.convert(sent, back);
  }
  const auto elapsed = static_cast<double>(now() - begin);
  same = same && sent == back;
  Figures()
      .add("bytes", static_cast<double>(bytes))
      .add("same", same ? 1 : 0)
      .add("ns", elapsed / static_cast<double>(options.count))
      .print();
}

}  // namespace peers
