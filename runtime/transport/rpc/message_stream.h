#pragma once
// The only byte stream Cap'n Proto sees in this runtime: buffered in both directions and guarded.

#include <suture/transport/rpc/kj_comparisons.h>  // first

#include <capnp/serialize-async.h>
#include <kj/async-unix.h>
#include <kj/vector.h>
#include <suture/transport/rpc/event_port.h>
#include <suture/transport/rpc/frame_header.h>
#include <suture/transport/rpc/receive_buffer.h>
#include <suture/transport/rpc/write_observer.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace suture::rpc {

/// Bytes that crossed a link. Written by the control thread, read by any.
struct LinkCounters {
  std::atomic<std::uint64_t> sentBytes{0};
  std::atomic<std::uint64_t> receivedBytes{0};
};

/// Messages over a connected, non-blocking stream socket (Unix or TCP). Belongs to the control
/// thread.
///
/// One receive brings as many messages as have arrived; messages written during one turn of the
/// event loop leave in one send. A peer that breaks the limits gets its connection ended with a
/// kj::Exception from the pending read; nothing it sent beyond that point is looked at. Descriptors
/// are not carried: those offered to writeMessage() are ignored and tryReadMessage() never delivers
/// any.
class MessageStream final : public capnp::MessageStream, private EventPort::Output {
 public:
  MessageStream(EventPort& port, kj::AutoCloseFd socket, StreamLimits limits = {});
  ~MessageStream() noexcept(false);

  using capnp::MessageStream::tryReadMessage;
  using capnp::MessageStream::writeMessage;
  using capnp::MessageStream::writeMessages;

  kj::Promise<kj::Maybe<capnp::MessageReaderAndFds>> tryReadMessage(
      kj::ArrayPtr<kj::AutoCloseFd> descriptors, capnp::ReaderOptions options,
      kj::ArrayPtr<capnp::word> scratch) override;
  kj::Promise<void> writeMessage(
      kj::ArrayPtr<const int> descriptors,
      kj::ArrayPtr<const kj::ArrayPtr<const capnp::word>> segments) override;
  kj::Promise<void> writeMessages(
      kj::ArrayPtr<kj::ArrayPtr<const kj::ArrayPtr<const capnp::word>>> messages) override;
  kj::Maybe<int> getSendBufferSize() override;
  kj::Promise<void> end() override;

  using Segments = kj::ArrayPtr<const kj::ArrayPtr<const capnp::word>>;

  /// Messages of which `mayWait` is true leave with the next message of another kind, or after
  /// kLongestRide: worth a system call and a wake-up of the peer each.
  void letRide(bool (*mayWait)(Segments message)) { mayWait_ = mayWait; }
  static constexpr int kLongestRideMilliseconds = 5;

  /// Shared, so that it outlives the link for whoever reports.
  std::shared_ptr<const LinkCounters> counters() const { return counters_; }

 private:
  using Reading = kj::Promise<kj::Maybe<capnp::MessageReaderAndFds>>;
  enum class Received { Some, Nothing, End };

  Reading read(capnp::ReaderOptions options);
  Reading waitAndRead(capnp::ReaderOptions options);
  kj::Maybe<capnp::MessageReaderAndFds> takeMessage(capnp::ReaderOptions options);
  Received receive();
  kj::Maybe<kj::TimePoint> readDeadline();

  kj::Promise<void> write(Segments segments);
  void scheduleRide();
  void flush() override;
  void awaitRoom();
  kj::Promise<void> whenDrained();
  void discardSent();
  void drained();
  void fail(kj::Exception exception);

  EventPort& port_;
  kj::AutoCloseFd socket_;  // before the observers: they must go first
  StreamLimits limits_;
  std::shared_ptr<LinkCounters> counters_ = std::make_shared<LinkCounters>();

  kj::UnixEventPort::FdObserver readObserver_;
  kj::Maybe<kj::Promise<void>> readable_;  // set: the socket was empty when this was made
  ReceiveBuffer incoming_;
  bool anyMessage_ = false;
  kj::TimePoint opened_;
  kj::Maybe<kj::TimePoint> partialSince_;

  std::vector<std::byte> outgoing_;
  std::size_t outgoingBegin_ = 0;
  bool awaitingRoom_ = false;  // the socket is full
  bool rideScheduled_ = false;
  bool (*mayWait_)(Segments) = nullptr;
  kj::Maybe<kj::Exception> writeFailure_;
  kj::Vector<kj::Own<kj::PromiseFulfiller<void>>> awaitingDrain_;
  kj::Maybe<kj::Own<WriteObserver>> writeObserver_;  // made the first time the socket is full
  kj::Promise<void> rideTask_ = kj::READY_NOW;
  kj::Promise<void> roomTask_ = kj::READY_NOW;  // the tasks last: cancelled first
};

}  // namespace suture::rpc
