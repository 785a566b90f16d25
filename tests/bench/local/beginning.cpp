#include <suture/component/channel/channel.h>

#include <memory>

#include "bench/figures/table.h"
#include "bench/local/rows.h"
#include "bench/sample_loop.suture.h"
#include "bench/timed_loops.h"

namespace bench {
namespace {

using suture::Arena;
using suture::Channel;
using suture::MemoryBlock;

constexpr suture::Duration kSilence = std::chrono::hours(1);

/// A ProvidersEnd is the provider's end of a connection, on memory of its own or on memory that its
/// client may write.
class ProvidersEnd {
 public:
  explicit ProvidersEnd(suture::Duration silence, Arena memory = {})
      : channel_(contract(), Channel::Terms{.name = "client -> provider"}, "",
                 {.client = bell_,
                  .provider = bell_,
                  .peer = std::make_shared<suture::PeerState>(),
                  .silence = silence},
                 makeStateTable(contract(), suture::rt::StateTable::Readers::Here),
                 suture::EventSet{0}, std::move(memory)) {}

  static Arena sharedMemory() {
    return {std::make_shared<MemoryBlock>("bench-channel", Channel::bytesFor(contract())),
            Arena::Content::Zeros};
  }

  Statistics measure(const LocalOptions& options, bool looksAtClock) {
    const auto measured = [&](const auto& begin) {
      return timedLoops(options.count(200), 100'000, [&] {
        suture::Errc over = begin();
        keep(over);
      });
    };
    if (!looksAtClock) return measured([&] { return channel_.provider.begin(nullptr); });
    return measured([&] {
      const suture::BootTime present = suture::BootClock::now();
      return channel_.provider.begin(&present);
    });
  }

 private:
  static const suture::InterfaceInfo& contract() { return suture::interfaceInfo<SampleServer>(); }

  const std::shared_ptr<suture::rt::Doorbell> bell_ = std::make_shared<suture::rt::Doorbell>();
  Channel channel_;
};

}  // namespace

std::string beginningRows(const LocalOptions& options, Report& report) {
  Table table(1);
  table.row(joined({"ns, whether a command may begin"}, statisticsTitles()));
  table.line();
  const Statistics loop = timedLoops(options.count(200), 100'000, [] {
    suture::Errc over{};
    keep(over);
  });
  table.row(joined({"the loop alone"}, cellsOf(loop, 1)));
  const auto row = [&](const char* title, const std::string& figure, const Statistics& cost) {
    report.add("begin." + figure, "ns", cost);
    report.add("begin." + figure + ".extra", "ns", cost.p50 - loop.p50);
    table.row(joined({title}, cellsOf(cost, 1)));
  };
  ProvidersEnd local(suture::Duration{0});
  row("`local`", "local", local.measure(options, false));
  ProvidersEnd remote(kSilence);
  row("`frame` and `rpc`", "remote", remote.measure(options, true));
  ProvidersEnd shared(kSilence, ProvidersEnd::sharedMemory());
  row("`shm` without a ttl", "shm", shared.measure(options, false));
  row("`shm` with a ttl", "shm_ttl", shared.measure(options, true));
  return table.toString();
}

}  // namespace bench
