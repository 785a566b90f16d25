#include <suture/transport/rpc/provider_end.h>

namespace suture::rpc {

void ProviderEnd::close() {
  if (closed_) return;
  closed_ = true;
  ending();
  channel_->status = ChannelStatus::Closed;
  channel_->ends.provider->ring();
  channel_->ends.client->ring();  // whoever carries it lets go
}

void ProviderEnd::end() {
  if (closed_) return;
  overtaken();
  passOn(ChannelStatus::Closed);
  close();
}

void ProviderEnd::pumpStatus() {
  const std::uint32_t faults = channel_->faults.load(std::memory_order_acquire);
  const ChannelStatus status = channel_->status.load(std::memory_order_acquire);
  // Restarted before anybody looked: the client is to know all the same.
  if (faults != faultsTold_ && told_ != ChannelStatus::Faulted) passOn(ChannelStatus::Faulted);
  faultsTold_ = faults;
  if (status != told_) passOn(status);
}

void ProviderEnd::passOn(ChannelStatus status) {
  told_ = status;
  changed(status);
  KJ_IF_MAYBE (listener, listener_) (*listener)->told(status);
}

}  // namespace suture::rpc
