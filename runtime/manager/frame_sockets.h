#pragma once
// How the socket of a frame connection comes to both ends: handed over on a Unix socket, or as a
// second connection that shows a token.

#include <suture/transport/rpc/kj_comparisons.h>  // first

#include <suture/peer.capnp.h>
#include <suture/transport/frame/lane_thread.h>
#include <suture/transport/frame/provider_side.h>
#include <suture/transport/rpc/opening.h>
#include <suture/transport/rpc/peer_identity.h>

#include <cstdint>
#include <map>
#include <memory>

namespace suture {

/// A provider's end that has no socket yet.
struct AwaitingSocket {
  std::shared_ptr<Channel> channel;
  frame::Terms terms;
  bool readOnly = false;
};

/// The provider's ends of a process on their way to the lane thread. Belongs to the control thread.
class FrameSockets {
 public:
  explicit FrameSockets(frame::LaneThread& lane) : lane_(lane) {}

  /// Rung by providers for what goes out.
  std::shared_ptr<rt::Doorbell> doorbell() { return lane_.doorbell(); }

  /// Carries `end` on one of a pair of sockets, and returns the other. Throws SetupError if the
  /// kernel refuses.
  wire::FrameSocket::Client handOver(const AwaitingSocket& end);
  /// The next connection of `who` that shows the token carries `end`. Throws SetupError likewise.
  rpc::Token await(const AwaitingSocket& end, const rpc::PeerIdentity& who);
  /// A connection has come and shows `token`. One that nobody awaits, or not any more, or not of
  /// this peer, is closed.
  void arrived(const rpc::Token& token, rpc::ByteStream bytes);

 private:
  struct Awaited {
    AwaitingSocket end;
    rpc::PeerIdentity who;
  };

  void carry(const AwaitingSocket& end, rpc::ByteStream bytes);

  frame::LaneThread& lane_;
  std::map<rpc::Token, Awaited> awaited_;
};

/// Of frames of one connection, most likely of no other. Throws SetupError if the kernel refuses.
std::uint32_t randomEpoch();

/// The client's end of a socket that was handed over.
kj::Promise<rpc::ByteStream> receiveSocket(wire::FrameSocket::Client socket);
/// Says on a second connection what it is for, and waits until the provider says the same.
kj::Promise<rpc::ByteStream> showToken(kj::UnixEventPort& port, rpc::ByteStream bytes,
                                       capnp::Data::Reader token);

}  // namespace suture
