#include <suture/lane/frame/frame_end.h>

namespace suture::frame {

FrameEnd::FrameEnd(loop::ControlThread& control, std::shared_ptr<Channel> channel,
                   std::shared_ptr<frame::Connection> connection)
    : ClientEnd(std::move(channel)), control_(control), connection_(std::move(connection)) {
  control_.add(*this);
}

void FrameEnd::pump() {
  if (connection_->broken()) tellBroken("closed: its frames end: " + connection_->why());
}

}  // namespace suture::frame
