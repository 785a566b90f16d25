#include <suture/lane/frame/frame_links.h>
#include <suture/lane/frame/frame_sockets.h>

#include <algorithm>
#include <utility>

namespace suture {

bool FrameLinks::Known::isOver() const {
  const Link held = link.lock();
  return awaiting.empty() && (held == nullptr || held->broken());
}

std::string FrameLinks::client(const std::string& provider, Duration silence) {
  Provider& known = providers_[provider];
  for (auto& [epoch, one] : known.links) {
    std::erase_if(one.awaiting, [](auto& who) { return !who->isWaiting(); });
  }
  const std::size_t ended =
      std::erase_if(known.links, [](const auto& one) { return one.second.isOver(); });
  if (ended > 0) known.name.reset();
  if (!known.name) fillWithRandom(known.name.emplace().data(), known.name->size());
  return std::string(known.name->begin(), known.name->end()) + std::to_string(silence.count());
}

// Rings the lane thread, which then ends the links that nobody has joined meanwhile.
FrameLinks::Hold::~Hold() {
  if (links_.empty()) return;
  links_.clear();
  bell_->ring();
}

FrameLinks::Hold FrameLinks::hold(const std::string& provider) {
  std::vector<Link> links;
  for (const auto& [epoch, known] : providers_[provider].links) {
    if (Link link = known.link.lock()) links.push_back(std::move(link));
  }
  return {std::move(links), doorbell()};
}

FrameLinks::Link FrameLinks::open(const std::string& provider, std::uint32_t epoch,
                                  rpc::ByteStream bytes) {
  auto link = std::make_shared<frame::Link>(kj::mv(bytes), epoch);
  Known& known = providers_[provider].links[epoch];
  known.link = link;
  for (auto& one : std::exchange(known.awaiting, {})) one->fulfill(Link(link));
  lane_.add(link);
  return link;
}

kj::Promise<FrameLinks::Link> FrameLinks::find(const std::string& provider, std::uint32_t epoch) {
  Known& known = providers_[provider].links[epoch];
  if (Link link = known.link.lock()) return kj::mv(link);
  auto pair = kj::newPromiseAndFulfiller<Link>();
  known.awaiting.push_back(kj::mv(pair.fulfiller));
  return kj::mv(pair.promise);
}

}  // namespace suture
