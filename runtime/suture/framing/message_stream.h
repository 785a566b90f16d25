#pragma once
// This is the only byte stream that Cap'n Proto uses in this runtime: buffered in both directions
// and guarded.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/rpc.h>
#include <kj/async-unix.h>
#include <kj/function.h>
#include <suture/framing/message_header.h>
#include <suture/framing/peer_budget.h>
#include <suture/framing/receive_buffer.h>
#include <suture/loop/event_port.h>
#include <suture/loop/write_observer.h>
#include <suture/net/byte_stream.h>
#include <suture/net/descriptor_passing.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace suture::framing {

/// The control thread writes it, any thread may read. Counts the bytes that crossed a link, without
/// what TLS adds.
struct LinkCounters {
  std::atomic<std::uint64_t> sentBytes{0};
  std::atomic<std::uint64_t> receivedBytes{0};
};

/// Bounds what a peer that connected to us costs while we do not know it.
struct StrangerGuard {
  std::shared_ptr<const bool> known;  ///< true once it has said who it is; null: it is known
  std::unique_ptr<PeerBudget::Share> share;
};

/// Belongs to the control thread. Sends and receives messages over a connected, non-blocking stream
/// socket (Unix or TCP), plain or inside TLS.
///
/// One receive brings as many messages as have arrived, and all messages that are written during
/// one turn of the event loop leave in one send. If a peer breaks the limits, the pending read
/// rejects with a kj::Exception, the connection ends, and nothing that the peer sent beyond that
/// point is looked at.
class MessageStream final : private loop::EventPort::Output {
 public:
  /// `begun` is what has been received already. A peer that we have called needs no `guard`: all of
  /// its messages may be long, and nothing bounds their sum.
  MessageStream(loop::EventPort& port, net::ByteStream bytes, StreamLimits limits = {},
                std::span<const std::byte> begun = {}, StrangerGuard guard = {});
  ~MessageStream() noexcept(false);

  const StreamLimits& limits() const { return limits_; }

  /// Judges each message that has arrived, knowing whether it comes from a stranger. Returns which
  /// limit the peer breaks by it; "" if none.
  using Judge = kj::Function<std::string_view(capnp::IncomingRpcMessage&, bool)>;
  void setJudge(Judge judge) { judge_ = kj::mv(judge); }

  using Reading = kj::Promise<kj::Maybe<kj::Own<capnp::IncomingRpcMessage>>>;
  using Segments = kj::ArrayPtr<const kj::ArrayPtr<const capnp::word>>;

  /// Returns the next message; nothing at the end of the stream. Rejects if the connection is lost
  /// or the peer breaks a limit. Only one read at a time.
  Reading read();

  /// Says when a message leaves.
  enum class Leaves {
    AtEndOfTurn,      ///< when the event loop has nothing else to do
    WithNextMessage,  ///< with the next message, or after kLongestDelayMilliseconds: for what is
                      ///< not worth a system call and a wake-up of the peer of its own
  };
  static constexpr int kLongestDelayMilliseconds = 5;

  /// Returns the address that this end has dialled; "": none.
  const std::string& dialled() const { return bytes_.dialled(); }
  /// Returns why a read has rejected, if the peer broke a limit; else "".
  const std::string& refusal() const { return refusal_; }

  /// Copies the message, and duplicates `descriptors` (Unix sockets only). If the connection is
  /// lost this does nothing, because the reader gets the error.
  void write(Segments message, Leaves when = Leaves::AtEndOfTurn,
             kj::ArrayPtr<const int> descriptors = nullptr);
  /// Sends what has been written, then closes this direction. Rejects if the connection is lost.
  kj::Promise<void> end();

  /// Returns the counters, which are shared so that they outlive the link for reports.
  std::shared_ptr<const LinkCounters> counters() const { return counters_; }

 private:
  enum class Received { Some, Nothing, End };

  Reading readBuffered();
  Reading waitAndRead();
  kj::Maybe<kj::Own<capnp::IncomingRpcMessage>> takeMessage();
  void countUnfinished();
  Received receive();
  kj::Maybe<kj::TimePoint> readDeadline();
  std::uint64_t taken() const;
  bool isStranger() const;
  void noteWhetherKnown();
  [[noreturn]] void refuse(std::string why);

  void scheduleDelayedSend();
  void flush() override;
  ssize_t sendSome();
  void awaitRoom();
  void observeRoom();
  void discardSent();
  void drained();
  void fail(kj::Exception exception);

  loop::EventPort& port_;
  net::ByteStream bytes_;  // before the observers: they must go first
  StreamLimits limits_;
  StrangerGuard guard_;
  std::shared_ptr<LinkCounters> counters_ = std::make_shared<LinkCounters>();

  loop::EventPort::FdObserver readObserver_;
  kj::Maybe<kj::Promise<void>> readable_;  // set: the socket was empty when this was made
  ReceiveBuffer incoming_;
  net::AttachedDescriptors arrivedDescriptors_;
  Judge judge_ = [](capnp::IncomingRpcMessage&, bool) { return std::string_view(); };
  bool anyMessage_ = false;
  kj::TimePoint opened_;
  kj::Maybe<kj::TimePoint> partialSince_;
  std::string refusal_;

  std::vector<std::byte> outgoing_;
  std::size_t outgoingBegin_ = 0;
  net::AttachedDescriptors outgoingDescriptors_;
  bool awaitingRoom_ = false;  // the socket is full
  bool delayedSendScheduled_ = false;
  kj::Maybe<kj::Exception> writeFailure_;
  kj::Maybe<kj::Own<kj::PromiseFulfiller<void>>> ending_;
  kj::Maybe<kj::Own<loop::WriteObserver>> writeObserver_;  // made the first time the socket is full
  kj::Promise<void> delayedSendTask_ = kj::READY_NOW;
  kj::Promise<void> roomTask_ = kj::READY_NOW;  // the tasks last: cancelled first
};

}  // namespace suture::framing
