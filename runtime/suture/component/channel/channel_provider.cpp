#include <suture/component/channel/channel.h>

#include <utility>

namespace suture {

ChannelProvider::ChannelProvider(Channel& channel, ChannelWords& words, Lease clientLease,
                                 bool keepsAges)
    : lease(std::move(clientLease)),
      commandAge(keepsAges ? std::make_unique<rt::Histogram>() : nullptr),
      channel_(channel),
      words_(words) {}

EventSet ChannelProvider::takeJoining() {
  return joining() ? words_.joining.exchange(0, std::memory_order_acquire) : 0;
}

Errc ChannelProvider::begin(const BootTime* present) {
  if (channel_.foreign && words_.cut.isUp(std::memory_order_seq_cst)) return Errc::Lost;
  if (present != nullptr && lease.lapsed(*present)) channel_.tell(ChannelStatus::Lapsed);
  const ChannelStatus status = channel_.status.load(std::memory_order_acquire);
  return isOver(status) ? errorOf(status) : Errc{};
}

void ChannelProvider::replyError(std::uint32_t call, Errc error) {
  reply(call, {}, [error](std::byte*) { return error; });
}

}  // namespace suture
