#include <suture/component/channel/channel.h>
#include <suture/component/contract/unbounded.h>
#include <suture/component/provided.h>

namespace suture {

ProvidedBase::ProvidedBase(Component& owner, std::string_view name, const InterfaceInfo& info,
                           void* implementation)
    : implementation_(implementation), clients_(owner, name, info) {
  refuseUnbounded(info, owner.ownsThread());
  owner.provided_.push_back(this);
}

ProvidedBase::~ProvidedBase() { std::erase(owner().provided_, this); }

void* ProvidedBase::implementation(const InterfaceInfo& contract) const {
  void* pointer = implementation_;
  for (const InterfaceInfo* one = &info(); one != &contract && one->base != nullptr;
       one = &one->base()) {
    pointer = one->toBase(pointer);
  }
  return pointer;
}

void ProvidedBase::attach(std::shared_ptr<Channel> channel) {
  clients_.add(channel);
  emission_.greetLocal(*channel);
  clients_.tellState(*channel);
  channel->ends.provider->ring();
}

void ProvidedBase::drain() {
  clients_.takeNews([this](const ConnectedClient& client, ClientNews news) {
    owner().onClient(*this, client, news);
  });
  clients_.dropEnded();
  commands_.begin();
  channels().forEach([this](ChannelList::Node& node) {
    Channel& channel = *node.channel;
    if (channel.ends.asked != nullptr) {
      channel.state->askAll(channel.ends.asked->load(std::memory_order_acquire));
    }
    const bool any = channel.commands.pending();
    // Fix the cut first, so that a command's events reach those who subscribed before they sent it.
    if (any) channel.commands.fixCut();
    emission_.greet(node);
    if (any) commands_.drain(node);
  });
}

void ProvidedBase::publishRow() {
  if (!rows_.areManual()) advance();
}

}  // namespace suture
