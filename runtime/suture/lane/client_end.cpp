#include <suture/lane/client_end.h>

#include <utility>

namespace suture {

void ClientEnd::onBroken(kj::Function<void(std::string)> broken) {
  if (!whyBroken_.empty()) return broken(whyBroken_);
  broken_ = kj::mv(broken);
}

void ClientEnd::tellBroken(std::string why) {
  if (!whyBroken_.empty() || closed_) return;
  whyBroken_ = std::move(why);
  KJ_IF_MAYBE (broken, broken_) (*broken)(whyBroken_);
}

void ClientEnd::close(ChannelStatus why) {
  if (closed_) return;
  closed_ = true;
  broken_ = nullptr;
  ending();
  channel_->client.cut();
  channel_->status.store(why, std::memory_order_release);
  channel_->noteStatus(why);
  channel_->ends.client->ring();
  channel_->ends.provider->ring();  // a thread that carries it drops it then
}

}  // namespace suture
