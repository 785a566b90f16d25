#include <vector>

#include "harness/clock.h"
#include "harness/figures.h"
#include "harness/measurements/contact.h"
#include "harness/measurements/measurements.h"

namespace peers {
namespace {

struct Size {
  std::size_t bytes;
  long count;
};
constexpr Size kSizes[] = {{120, 5000}, {1024, 5000}, {65536, 2000}, {1048576, 300}};
constexpr std::size_t kLeastCount = 10;  // whatever the time

Blob blobOf(std::size_t bytes) {
  Blob blob;
  blob.data.resize(bytes / sizeof(double));
  for (std::size_t i = 0; i < blob.data.size(); ++i) blob.data[i] = 0.5 * static_cast<double>(i);
  return blob;
}

/// An earlier blob, or one that is cut off, differs in this; to compare all of it would warm the
/// caches of the client.
bool same(const Blob& sent, const Blob& back) {
  return back.timestamp == sent.timestamp && back.data.size() == sent.data.size() &&
         back.data.back() == sent.data.back() && back.data[1] == sent.data[1];
}

void measureSize(Client& client, const Size& size, double seconds) {
  Blob sent = blobOf(size.bytes), back;
  bool allSame = true;
  std::vector<double> times;
  const std::int64_t end = now() + static_cast<std::int64_t>(seconds * kSecond);
  const long warmUp = size.count / 10;
  for (long i = -warmUp; i < size.count && (now() < end || times.size() < kLeastCount); ++i) {
    sent.timestamp = sent.data.back() = static_cast<double>(i);
    const std::int64_t begin = now();
    client.echo(sent, back);
    const std::int64_t arrived = now();
    allSame = allSame && same(sent, back);
    if (i >= 0) times.push_back(1e-3 * static_cast<double>(arrived - begin));
  }
  Figures()
      .add("bytes", static_cast<double>(size.bytes))
      .add("same", allSame ? 1 : 0)
      .add(statisticsOf(std::move(times)))
      .print();
}

}  // namespace

void measurePayloads(Peer& peer, const Options& options, ControlBlock&) {
  if (const std::string why = peer.lacksBlobs(); !why.empty()) {
    return Figures().add("without", why).print();
  }
  const auto client = peer.client(options, 0);
  reachByEcho(*client, blobOf(kSizes[0].bytes));
  for (const Size& size : kSizes) measureSize(*client, size, options.seconds);
}

}  // namespace peers
