#include <suture/base/time.h>
#include <suture/codec/stamps.h>
#include <suture/codec/text.h>
#include <suture/component/channel/channel.h>
#include <suture/session/provider/connection_states.h>

#include <memory>
#include <string_view>
#include <vector>

namespace suture {
namespace {

struct Connected {
  const RequiredBase* required;
  std::shared_ptr<Channel> channel;
};

std::vector<Connected> connectedIn(const Directory& directory) {
  std::vector<Connected> all;
  for (const Component* component : directory.components()) {
    for (const RequiredBase* required : component->required()) {
      if (auto channel = required->attached()) all.push_back({required, std::move(channel)});
    }
  }
  return all;
}

void toWire(const Connected& one, wire::ConnectionState::Builder out) {
  const Channel& channel = *one.channel;
  const ConnectionWatch* const watch = channel.terms.watch.get();
  out.setComponent(codec::textOf(one.required->owner().name()));
  out.setRequired(codec::textOf(one.required->name()));
  out.setProvided(codec::textOf(std::string(channel.providerName())));
  out.setLane(codec::textOf(channel.lane));
  out.setStatus(toString(channel.status.load(std::memory_order_acquire)));
  out.setSince(toNanoseconds(channel.statusSince.load(std::memory_order_relaxed)));
  out.setAwaitsOperator(watch != nullptr && watch->awaitsOperator);
}

}  // namespace

void tellConnections(const Directory& directory, wire::Peer::DescribeResults::Builder out) {
  const std::vector<Connected> all = connectedIn(directory);
  auto states = out.initConnections(static_cast<unsigned>(all.size()));
  for (unsigned i = 0; i < all.size(); ++i) toWire(all[i], states[i]);
}

}  // namespace suture
