#pragma once
// The two ends of a connection that travels as frames, whatever carries their bytes.

#include <suture/lane/frame/lane_thread.h>
#include <suture/lane/frame/link.h>
#include <suture/lane/lane_kind.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace suture::frame {

/// Both ends agree on the lane, the number and the form; the rest carries their frames in this
/// process.
struct FramedOn {
  const char* lane;  ///< its name
  LaneThread& thread;
  std::shared_ptr<Link> link;  ///< an empty one lives as long as somebody holds it
  std::uint32_t number;        ///< of the connection on the link
  Form form = Form::Slots;
};

/// The control thread makes the client's end.
OpenedEnd openFramed(OutgoingConnection connection, const FramedOn& on,
                     rpc::ControlThread& control);

/// The provider's end. `commands`: by the number that the client gives a command, its number here;
/// empty if the two have the same numbers. The control thread.
AcceptedEnd acceptFramed(const IncomingConnection& connection, const FramedOn& on,
                         rpc::ControlThread& control, std::vector<std::uint16_t> commands = {});

}  // namespace suture::frame
