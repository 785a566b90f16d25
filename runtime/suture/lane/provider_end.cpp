#include <suture/lane/provider_end.h>

namespace suture {

Earlier ProviderEnd::earlier() {
  const Earlier earlier = channel_->terms.ledger->before(*channel_);
  earlierTold_ = earlier.ended;
  return earlier;
}

void ProviderEnd::tellEarlier() {
  if (earlierTold_ || closed_ || channel_->terms.ledger == nullptr) return;
  const Earlier last = earlier();
  if (!last.ended) return;
  KJ_IF_MAYBE (listener, listener_) (*listener)->tells(last);
}

BootTime ProviderEnd::endOfLease() const {
  return isOver(channel_->status.load()) ? BootTime::max() : channel_->provider.lease.end();
}

void ProviderEnd::lapse() {
  channel_->tell(ChannelStatus::Lapsed);
  channel_->ends.provider->ring();  // its component must be told
}

void ProviderEnd::close() {
  if (closed_) return;
  closed_ = true;
  ending();
  channel_->status = ChannelStatus::Closed;
  channel_->ends.provider->ring();
  channel_->ends.client->ring();  // if a thread carries this channel, it drops it
}

void ProviderEnd::end() {
  if (closed_) return;
  passOn(ChannelStatus::Closed);
  close();
}

void ProviderEnd::pumpStatus() {
  const std::uint32_t faults = channel_->faults.load(std::memory_order_acquire);
  const ChannelStatus status = channel_->status.load(std::memory_order_acquire);
  // Tell the client of a fault, even if the provider was restarted before anyone looked.
  if (faults != faultsTold_ && told_ != ChannelStatus::Faulted) passOn(ChannelStatus::Faulted);
  faultsTold_ = faults;
  if (status != told_) passOn(status);
}

void ProviderEnd::passOn(ChannelStatus status) {
  told_ = status;
  changed(status);
  KJ_IF_MAYBE (listener, listener_) (*listener)->told(status);
}

}  // namespace suture
