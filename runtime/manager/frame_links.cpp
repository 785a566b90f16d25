#include <suture/manager/frame_links.h>
#include <suture/manager/frame_sockets.h>

namespace suture {

FrameLinks::FrameLinks(frame::LaneThread& lane) : lane_(lane) {
  fillWithRandom(id_.data(), id_.size());
}

std::string FrameLinks::client(Duration silence) const {
  return std::string(id_.begin(), id_.end()) + std::to_string(silence.count());
}

// The lane thread looks again whether anybody has joined what it kept for us.
FrameLinks::Hold::~Hold() {
  if (links_.empty()) return;
  links_.clear();
  bell_->ring();
}

FrameLinks::Hold FrameLinks::hold() {
  std::vector<Link> links;
  for (const auto& [name, known] : links_) {
    if (Link link = known.link.lock()) links.push_back(std::move(link));
  }
  return {std::move(links), doorbell()};
}

FrameLinks::Link FrameLinks::open(const Name& name, rpc::ByteStream bytes) {
  std::erase_if(links_, [](const auto& one) {
    return one.second.link.expired() && one.second.awaiting.empty();
  });
  const auto link = std::make_shared<frame::Link>(kj::mv(bytes), name.second);
  Known& known = links_[name];
  known.link = link;
  for (auto& one : std::exchange(known.awaiting, {})) one->fulfill(Link(link));
  lane_.add(link);
  return link;
}

kj::Promise<FrameLinks::Link> FrameLinks::find(const Name& name) {
  Known& known = links_[name];
  if (Link link = known.link.lock()) return kj::mv(link);
  auto pair = kj::newPromiseAndFulfiller<Link>();
  known.awaiting.push_back(kj::mv(pair.fulfiller));
  return kj::mv(pair.promise);
}

}  // namespace suture
