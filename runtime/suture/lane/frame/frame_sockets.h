#pragma once
// How the socket of a frame link comes to both ends: handed over on a Unix socket, or as a second
// connection that shows a token.

#include <suture/loop/kj_comparisons.h>  // first

#include <suture/framing/preamble.h>
#include <suture/lane/frame/lane_thread.h>
#include <suture/lane/frame/provider_side.h>
#include <suture/net/peer_identity.h>
#include <suture/peer.capnp.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace suture {

/// A provider's end of a connection that no link carries yet.
struct UncarriedEnd {
  std::shared_ptr<Channel> channel;
  bool readOnly = false;
};

/// The client whose connections may share a link.
struct FrameClient {
  std::string name;  ///< "": it shares none
  rpc::PeerIdentity who;
  bool handsOver = false;  ///< can be handed a socket
};

/// The provider's ends of a process on their way to the lane thread. Belongs to the control thread.
class FrameSockets {
 public:
  explicit FrameSockets(frame::LaneThread& lane) : lane_(lane) {}

  /// Rung by providers for what goes out.
  std::shared_ptr<rt::Doorbell> doorbell() { return lane_.doorbell(); }

  /// What an offer says: how the client's end comes to the link.
  struct Offered {
    std::uint32_t epoch = 0, connection = 0;
    // Neither: the client has its socket, or is getting it.
    kj::Maybe<wire::FrameSocket::Client> socket;
    kj::Maybe<rpc::Token> token;
  };
  /// Carries `end` on the link that the client has, or on a new one. Throws SetupError if the
  /// kernel refuses.
  Offered offer(const UncarriedEnd& end, const FrameClient& client);

  /// A connection has come and shows `token`. It is closed if nobody awaits it, or not any more, or
  /// not of this peer.
  void arrived(const rpc::Token& token, rpc::ByteStream bytes);

 private:
  /// A link that may have several connections, or is about to.
  struct Shared {
    /// False: it is over.
    bool take(const std::shared_ptr<frame::Connection>& connection);

    FrameClient client;
    std::weak_ptr<frame::Link> link;  // none until the socket has come
    kj::Maybe<rpc::Token> token;      // that it will show
    std::vector<std::shared_ptr<frame::Connection>> awaiting;
  };

  void makeLink(const std::shared_ptr<frame::Connection>& first, const FrameClient& client,
                Offered& offered);
  void begin(std::uint32_t epoch, Shared& shared, rpc::ByteStream bytes);
  void forgetEnded();

  frame::LaneThread& lane_;
  std::map<std::uint32_t, Shared> links_;  // by epoch
  std::uint32_t latest_ = 0;               // connection
};

/// Fills memory with what no peer can guess. Throws SetupError if the kernel refuses.
void fillWithRandom(void* memory, std::size_t size);

/// The client's end of a socket that was handed over.
kj::Promise<rpc::ByteStream> receiveSocket(wire::FrameSocket::Client socket);
/// Says on a second connection what it is for, and waits until the provider says the same.
kj::Promise<rpc::ByteStream> showToken(rpc::EventPort& port, rpc::ByteStream bytes,
                                       capnp::Data::Reader token);

}  // namespace suture
