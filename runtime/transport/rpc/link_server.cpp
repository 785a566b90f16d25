#include <suture/transport/rpc/failure.h>
#include <suture/transport/rpc/link_server.h>

#include <cstdio>

namespace suture::rpc {

using capnp::rpc::twoparty::Side;

LinkServer::LinkServer(EventPort& port, const Address& address, Offer offer, StreamLimits limits,
                       std::size_t maxLinks)
    : port_(port),
      listener_(port, address),
      offer_(kj::mv(offer)),
      limits_(limits),
      maxLinks_(maxLinks),
      tasks_(*this) {
  tasks_.add(listener_.listen([this](kj::AutoCloseFd socket) { accept(kj::mv(socket)); }));
}

void LinkServer::accept(kj::AutoCloseFd socket) {
  if (links_ == maxLinks_) return;
  auto stream = kj::heap<MessageStream>(port_, kj::mv(socket), limits_);
  auto offered = offer_(stream->counters());
  auto link = kj::heap<Link>(kj::mv(stream), Side::SERVER, kj::mv(offered));
  ++links_;
  auto gone = link->onDisconnect();
  tasks_.add(gone.attach(kj::mv(link), kj::defer([this] { --links_; })));
}

void LinkServer::taskFailed(kj::Exception&& exception) {
  std::fprintf(stderr, "suture: %s: %s\n", address().text().c_str(), describe(exception).c_str());
}

}  // namespace suture::rpc
