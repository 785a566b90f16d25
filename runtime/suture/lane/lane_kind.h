#pragma once
// What a lane is to the sessions that use it: one implementation a folder, all of them in lanes.h.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/any.h>
#include <kj/async.h>
#include <suture/component/channel/channel.h>
#include <suture/component/provided.h>
#include <suture/lane/client_end.h>
#include <suture/lane/provider_end.h>
#include <suture/loop/control_thread.h>
#include <suture/net/byte_stream.h>

#include <cstdint>
#include <memory>
#include <string>

namespace suture {

/// A socket between the two processes of a session, for one lane.
struct LaneSocket {
  std::uint32_t number = 0;  ///< what both processes call it
  rpc::ByteStream bytes;
};

/// What a lane may use of a session, in the client's process.
class ClientSession {
 public:
  virtual rpc::ControlThread& control() = 0;
  /// True if the control link is a Unix socket, so that both processes are on one machine.
  virtual bool carriesDescriptors() const = 0;
  /// True if both processes have one steady clock.
  virtual bool hasOneClock() const = 0;
  /// Opens one more socket to the provider, which gives it to the same lane there.
  virtual kj::Promise<LaneSocket> openSocket(const char* lane) = 0;

 protected:
  ~ClientSession() = default;
};

/// A connection that is to be made, in the client's process.
struct OutgoingConnection {
  const InterfaceInfo& contract;  ///< the client's
  Channel::Terms terms;           ///< which the provider adds to when it accepts
  EventSet events = 0;            ///< that the client wants
  std::shared_ptr<rt::Doorbell> client;
  std::shared_ptr<const PeerState> peer = nullptr;
  Duration silence{0};     ///< that the client bears
  std::uint32_t rows = 0;  ///< of state that the provider keeps, once it has accepted
};

/// A client's end that has been made. Its channel is not attached to the client yet.
struct OpenedEnd {
  kj::Own<rpc::ClientEnd> end;
  std::shared_ptr<Channel> channel;
};

/// One attempt to make a connection over a lane, in the client's process.
class LaneAttempt {
 public:
  virtual ~LaneAttempt() noexcept(false) = default;
  /// Tells the provider's end of the lane what that needs.
  virtual void request(capnp::AnyPointer::Builder out) = 0;
  /// The provider has accepted `connection`. Rejects with the reason if it cannot be had after all.
  virtual kj::Promise<OpenedEnd> open(OutgoingConnection connection,
                                      capnp::AnyPointer::Reader answer) = 0;
};

/// A lane in one session, in the client's process.
class LaneClient {
 public:
  virtual ~LaneClient() noexcept(false) = default;
  /// Why the connection cannot travel so; "" if it perhaps can.
  virtual std::string whyNot(const OutgoingConnection& connection) const = 0;
  /// Resolves as soon as the provider can be asked. Rejects with the reason if it cannot.
  virtual kj::Promise<kj::Own<LaneAttempt>> attempt(const OutgoingConnection& connection) = 0;
  /// The longest time for which a connection of the session bears an unanswered socket.
  virtual void bear(Duration /*silence*/) {}
};

/// What a lane may use of a session, in the provider's process.
class ServerSession {
 public:
  virtual rpc::ControlThread& control() = 0;

 protected:
  ~ServerSession() = default;
};

/// A connection that is to be made, in the provider's process.
struct IncomingConnection {
  ProvidedBase& provided;
  /// What the client means: the provider's own contract or one of its bases, though perhaps of
  /// another version.
  const InterfaceInfo& contract;
  Channel::Terms terms;
  EventSet events = 0;                     ///< that the client wants, as this process numbers them
  std::shared_ptr<rt::Doorbell> provider;  ///< of the thread that serves it
  bool readOnly = false;                   ///< the client may give no commands
  std::shared_ptr<const PeerState> peer = nullptr;
  Duration silence{0};  ///< that the client bears; 0: it does not say
};

/// A provider's end that has been made. Its channel is not attached to the provider yet.
struct AcceptedEnd {
  kj::Own<rpc::ProviderEnd> end;
  std::shared_ptr<Channel> channel;
};

/// A lane in one session, in the provider's process.
class LaneServer {
 public:
  virtual ~LaneServer() noexcept(false) = default;
  /// Makes the provider's end, and tells the client's what that needs. Throws SetupError, or
  /// rejects, with the reason if the connection cannot travel so.
  virtual kj::Promise<AcceptedEnd> accept(IncomingConnection connection,
                                          capnp::AnyPointer::Reader brings,
                                          capnp::AnyPointer::Builder answer) = 0;
  /// The client has opened a socket for this lane.
  virtual void opened(LaneSocket socket) = 0;
};

/// A way for connections to travel between two processes. Everything here belongs to the control
/// thread, and outlives the sessions.
class LaneKind {
 public:
  virtual ~LaneKind() noexcept(false) = default;
  /// For reports, deployments and the peer: "frame".
  virtual const char* name() const = 0;
  virtual kj::Own<LaneClient> makeClient(ClientSession& session) = 0;
  virtual kj::Own<LaneServer> makeServer(ServerSession& session) = 0;
  /// The thread that made it, behind the last session: rings nobody any more.
  virtual void stop() {}
};

}  // namespace suture
