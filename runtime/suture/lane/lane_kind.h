#pragma once
// This is what a lane is to the sessions that use it: each folder implements one, and lanes.h has
// all.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/any.h>
#include <kj/async.h>
#include <suture/component/channel/channel.h>
#include <suture/component/provided.h>
#include <suture/framing/peer_budget.h>
#include <suture/lane/client_end.h>
#include <suture/lane/provider_end.h>
#include <suture/loop/control_thread.h>
#include <suture/net/byte_stream.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace suture {

/// A LaneSocket is a socket between the two processes of a session, for one lane.
struct LaneSocket {
  std::uint32_t number = 0;  ///< both processes number it so
  net::ByteStream bytes;
  /// Counts what the peer has begun to send. It is null in the process that opened the socket.
  std::unique_ptr<framing::PeerBudget::Share> share = nullptr;
};

/// A ClientSession is what a lane may use of a session, in the client's process.
class ClientSession {
 public:
  virtual loop::ControlThread& control() = 0;
  /// Returns true if the control link is a Unix socket, so that both processes are on one machine.
  virtual bool carriesDescriptors() const = 0;
  /// Returns true if both processes have one steady clock.
  virtual bool hasOneClock() const = 0;
  /// Opens one more socket to the provider, which gives it to the same lane there.
  virtual kj::Promise<LaneSocket> openSocket(const char* lane) = 0;

 protected:
  ~ClientSession() = default;
};

/// Describes a connection that will be made, in the client's process.
struct OutgoingConnection {
  const InterfaceInfo& contract;  ///< the client's
  Channel::Terms terms;           ///< to which the provider adds when it accepts
  EventSet events = 0;            ///< those that the client wants
  std::shared_ptr<rt::Doorbell> client;
  std::shared_ptr<const PeerState> peer = nullptr;
  Duration silence{0};     ///< the longest that the client bears
  std::uint32_t rows = 0;  ///< how many the provider keeps, once it has accepted
};

/// Holds a client's end that has been made. Its channel is not attached to the client yet.
struct OpenedEnd {
  kj::Own<ClientEnd> end;
  std::shared_ptr<Channel> channel;
};

/// A LaneAttempt is one attempt to make a connection over a lane, in the client's process.
class LaneAttempt {
 public:
  virtual ~LaneAttempt() noexcept(false) = default;
  /// Writes into `out` what the provider's end of the lane needs to know.
  virtual void request(capnp::AnyPointer::Builder out) = 0;
  /// Makes the client's end of `connection`, which the provider has accepted with `answer`. Rejects
  /// with the reason if it cannot.
  virtual kj::Promise<OpenedEnd> open(OutgoingConnection connection,
                                      capnp::AnyPointer::Reader answer) = 0;
};

/// A LaneClient is a lane in one session, in the client's process.
class LaneClient {
 public:
  virtual ~LaneClient() noexcept(false) = default;
  /// Returns why the connection cannot use this lane; "" if it perhaps can.
  virtual std::string whyNot(const OutgoingConnection& connection) const = 0;
  /// Resolves as soon as the provider can be asked. Rejects with the reason if it cannot.
  virtual kj::Promise<kj::Own<LaneAttempt>> attempt(const OutgoingConnection& connection) = 0;
  /// Says for how long at most a connection of the session bears an unanswered socket.
  virtual void bear(Duration /*silence*/) {}
};

/// A ServerSession is what a lane may use of a session, in the provider's process.
class ServerSession {
 public:
  virtual loop::ControlThread& control() = 0;
  /// Tells the operator of this process why a socket of the peer was closed, or what it asked on
  /// one in vain.
  virtual void cutOff(const std::string& why) = 0;

 protected:
  ~ServerSession() = default;
};

/// Describes a connection that will be made, in the provider's process.
struct IncomingConnection {
  ProvidedBase& provided;
  /// The client has the contract in this form: the provider's own or one of its bases, though
  /// perhaps of another version.
  const InterfaceInfo& contract;
  Channel::Terms terms;
  EventSet events = 0;                     ///< those that the client wants, in our numbers
  std::shared_ptr<rt::Doorbell> provider;  ///< the thread that serves it waits there
  bool readOnly = false;                   ///< the client may give no commands
  std::shared_ptr<const PeerState> peer = nullptr;
  Duration silence{0};  ///< the longest that the client bears; 0: it does not say
};

/// Holds a provider's end that has been made. Its channel is not attached to the provider yet.
struct AcceptedEnd {
  kj::Own<ProviderEnd> end;
  std::shared_ptr<Channel> channel;
};

/// A LaneServer is a lane in one session, in the provider's process.
class LaneServer {
 public:
  virtual ~LaneServer() noexcept(false) = default;
  /// Makes the provider's end. `brings` is what the client's end asked for by request(), and
  /// `answer` takes what that needs to know. Throws SetupError, or rejects, with the reason if the
  /// connection cannot use this lane. Rejects as Type::OVERLOADED if it could, but something went
  /// wrong; then the operators of both processes are told.
  virtual kj::Promise<AcceptedEnd> accept(IncomingConnection connection,
                                          capnp::AnyPointer::Reader brings,
                                          capnp::AnyPointer::Builder answer) = 0;
  /// Returns how much memory accept() would take for the connection.
  virtual std::size_t bytesFor(const IncomingConnection& connection) const {
    return Channel::bytesFor(connection.contract);
  }
  /// Takes a socket that the client has opened for this lane.
  virtual void opened(LaneSocket socket) = 0;
};

/// Belongs to the control thread, except where a comment says otherwise, and outlives the sessions.
/// A LaneKind is a way for connections to travel between two processes.
class LaneKind {
 public:
  virtual ~LaneKind() noexcept(false) = default;
  /// Returns the name for reports, deployments and the peer: "frame".
  virtual const char* name() const = 0;
  /// Any thread. Returns why no connection of this contract can ever travel by it, whatever the two
  /// processes are; "" if one may. `byUnixSocket` says how they reach each other.
  virtual std::string whyNever(const InterfaceInfo& /*contract*/, bool /*byUnixSocket*/) const {
    return "";
  }
  virtual kj::Own<LaneClient> makeClient(ClientSession& session) = 0;
  virtual kj::Own<LaneServer> makeServer(ServerSession& session) = 0;
  /// The thread that made it, after the last session. From then on it rings no thread.
  virtual void stop() {}
};

}  // namespace suture
