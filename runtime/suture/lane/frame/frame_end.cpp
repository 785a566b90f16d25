#include <suture/lane/frame/frame_end.h>

namespace suture {

FrameEnd::FrameEnd(rpc::ControlThread& control, std::shared_ptr<Channel> channel,
                   std::shared_ptr<frame::Connection> connection)
    : ClientEnd(std::move(channel)),
      control_(control),
      connection_(std::move(connection)),
      whenBroken_(nullptr) {
  auto pair = kj::newPromiseAndFulfiller<std::string>();
  broken_ = kj::mv(pair.fulfiller);
  whenBroken_ = kj::mv(pair.promise);
  control_.add(*this);
}

void FrameEnd::pump() {
  if (broken_->isWaiting() && connection_->broken()) {
    broken_->fulfill("closed: its frames end: " + connection_->why());
  }
}

}  // namespace suture
