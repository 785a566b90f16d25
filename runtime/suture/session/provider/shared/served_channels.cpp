#include <suture/session/provider/shared/served_channels.h>

#include <utility>

namespace suture {

void ServedChannels::attach(ProvidedBase& provided, std::shared_ptr<Channel> channel) {
  provided.attach(channel);
  forgetClosed();
  const std::lock_guard lock(mutex_);
  all_.push_back(std::move(channel));
}

void ServedChannels::forgetClosed() {
  ledgers_.letGo();
  const std::lock_guard lock(mutex_);
  std::erase_if(all_, [](const auto& one) { return one->status == ChannelStatus::Closed; });
}

void ServedChannels::sweep() {
  for (const Component* const component : directory_.components()) {
    for (ProvidedBase* const provided : component->provided()) provided->sweep();
  }
}

std::vector<std::shared_ptr<Channel>> ServedChannels::all() const {
  const std::lock_guard lock(mutex_);
  return all_;
}

}  // namespace suture
