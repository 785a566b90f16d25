#pragma once
// These are the two ends of a connection that travels as frames, whatever carries their bytes.

#include <suture/lane/frame/frame_link.h>
#include <suture/lane/frame/lane_thread.h>
#include <suture/lane/frame/provider_side.h>
#include <suture/lane/lane_kind.h>

#include <cstdint>
#include <memory>

namespace suture::frame {

/// Says how frames travel: both ends agree on the lane, the number and the form; the rest carries
/// their frames in this process.
struct FramedOn {
  const char* lane;  ///< the lane's name
  LaneThread& thread;
  std::shared_ptr<FrameLink> link;  ///< an empty one lives only as long as it is held
  std::uint32_t number;             ///< the connection's number on the link
  Form form = Form::Slots;
};

/// The control thread. Makes the client's end.
OpenedEnd openFramed(OutgoingConnection connection, const FramedOn& on,
                     loop::ControlThread& control);

/// The control thread. Makes the provider's end.
AcceptedEnd acceptFramed(const IncomingConnection& connection, const FramedOn& on,
                         loop::ControlThread& control, ClientCommands commands = {});

}  // namespace suture::frame
