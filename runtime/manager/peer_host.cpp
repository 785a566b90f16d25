#include <suture/manager/peer_host.h>
#include <suture/manager/peer_server.h>

#include <fstream>

namespace suture {

PeerHost::PeerHost(rpc::ControlThread& control, const Directory& directory,
                   Network::ServerOf serverOf, const rpc::Address& address)
    : control_(control),
      directory_(directory),
      serverOf_(std::move(serverOf)),
      whenPublished_(nullptr),
      server_(
          control.port(), address,
          [this](std::shared_ptr<const rpc::LinkCounters> counters) -> capnp::Capability::Client {
            return wire::Peer::Client(kj::heap<PeerServer>(*this, std::move(counters)));
          }) {
  auto pair = kj::newPromiseAndFulfiller<void>();
  published_ = kj::mv(pair.fulfiller);
  whenPublished_ = pair.promise.fork();
}

std::vector<std::shared_ptr<Channel>> PeerHost::served() const {
  const std::lock_guard lock(mutex_);
  return served_;
}

void PeerHost::remember(std::shared_ptr<Channel> channel) {
  const std::lock_guard lock(mutex_);
  std::erase_if(served_, [](const auto& one) { return one->status == ChannelStatus::Closed; });
  served_.push_back(std::move(channel));
}

std::string bootId() {
  std::string id;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> id;
  return id;
}

}  // namespace suture
