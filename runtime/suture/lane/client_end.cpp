#include <suture/lane/client_end.h>

namespace suture::rpc {

void ClientEnd::close(ChannelStatus why) {
  if (closed_) return;
  closed_ = true;
  ending();
  channel_->client.cut();
  channel_->status.store(why, std::memory_order_release);
  channel_->noteStatus(why);
  channel_->ends.client->ring();
  channel_->ends.provider->ring();  // whoever carries it lets go
}

}  // namespace suture::rpc
