#include <suture/lane/mirrored_channel.h>

#include <algorithm>
#include <utility>

namespace suture {

std::shared_ptr<Channel> mirroredChannel(const OutgoingConnection& connection, const char* lane,
                                         rt::Doorbell& carrier, rpc::ControlThread& control,
                                         std::uint32_t rows) {
  constexpr std::size_t kMostBytes = std::size_t{64} << 20;
  const Channel::Ends ends{.client = connection.client.get(),
                           .provider = &carrier,
                           .watcher = &control.doorbell(),
                           .peer = connection.peer,
                           .silence = connection.silence};
  auto rowsHere = makeStateTable(connection.contract, rt::StateTable::Readers::Here);
  auto channel = std::make_shared<Channel>(connection.contract, connection.name, lane, ends,
                                           std::move(rowsHere), connection.events);
  channel->clientsBell = connection.client;
  rt::StateTable& mirror = *channel->state;
  const std::size_t most = std::max<std::size_t>(kMostBytes / mirror.rowBytes(), 1);
  const auto kept = static_cast<unsigned>(std::min<std::size_t>(rows, most));
  if (kept > mirror.capacity()) mirror.resize(kept);
  return channel;
}

}  // namespace suture
