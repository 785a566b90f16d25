#include <suture/lane/mirrored_channel.h>

#include <algorithm>
#include <utility>

namespace suture {

std::shared_ptr<Channel> mirroredChannel(OutgoingConnection connection, const char* lane,
                                         std::shared_ptr<rt::Doorbell> bell,
                                         loop::ControlThread& control) {
  constexpr std::size_t kMostBytes = std::size_t{64} << 20;
  auto mirror = makeStateTable(connection.contract, rt::StateTable::Readers::Here);
  const std::size_t most = std::max<std::size_t>(kMostBytes / mirror->rowBytes(), 1);
  const auto kept = static_cast<unsigned>(std::min<std::size_t>(connection.rows, most));
  if (kept > mirror->capacity()) mirror->resize(kept);
  return std::make_shared<Channel>(connection.contract, std::move(connection.terms), lane,
                                   Channel::Ends{.client = std::move(connection.client),
                                                 .provider = std::move(bell),
                                                 .components = ConnectionEnd::Client,
                                                 .watcher = control.sharedDoorbell(),
                                                 .peer = std::move(connection.peer),
                                                 .silence = connection.silence},
                                   std::move(mirror), connection.events);
}

}  // namespace suture
