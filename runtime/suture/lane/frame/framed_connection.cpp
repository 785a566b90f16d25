#include <suture/lane/frame/client_side.h>
#include <suture/lane/frame/frame_end.h>
#include <suture/lane/frame/framed_connection.h>
#include <suture/lane/frame/provider_port.h>
#include <suture/lane/mirrored_channel.h>
#include <suture/lane/providers_ends.h>

#include <utility>

namespace suture::frame {

OpenedEnd openFramed(OutgoingConnection connection, const FramedOn& on,
                     loop::ControlThread& control) {
  const std::shared_ptr<rt::Doorbell> bell = on.thread.doorbell();
  auto channel = mirroredChannel(std::move(connection), on.lane, bell, control);
  const auto side =
      std::make_shared<ClientSide>(channel, makePayloads(channel->info, on.form), on.number);
  auto end = kj::refcounted<FrameEnd>(control, channel, side);
  on.link->join(side);
  bell->ring();
  return OpenedEnd{kj::mv(end), std::move(channel)};
}

AcceptedEnd acceptFramed(const IncomingConnection& connection, const FramedOn& on,
                         loop::ControlThread& control, ClientCommands commands) {
  const InterfaceInfo& contract = connection.contract;
  const std::shared_ptr<rt::Doorbell> bell = on.thread.doorbell();
  auto channel =
      std::make_shared<Channel>(contract, connection.terms, on.lane,
                                providersEnds(connection, bell, control.sharedDoorbell()),
                                connection.provided.state(), connection.events);
  const auto side = std::make_shared<ProviderSide>(channel, makePayloads(contract, on.form),
                                                   on.number, std::move(commands));
  if (connection.readOnly) side->setReadOnly();
  auto end = kj::refcounted<ProviderPort>(control, channel, side);
  on.link->join(side);
  bell->ring();
  return AcceptedEnd{kj::mv(end), std::move(channel)};
}

}  // namespace suture::frame
