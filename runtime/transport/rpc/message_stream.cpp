#include <suture/transport/rpc/message_stream.h>

#include <suture/transport/rpc/failure.h>
#include <suture/transport/rpc/received_message.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>

namespace suture::rpc {
namespace {

// Beyond this much unsent data a writer is told to wait.
constexpr std::size_t kHighWater = 1u << 20;
// This much is worth a send of its own.
constexpr std::size_t kSendAtOnce = 1u << 16;

kj::Exception lost(int error) {
  return disconnected(std::string("connection lost: ") + std::strerror(error));
}

}  // namespace

MessageStream::MessageStream(EventPort& port, kj::AutoCloseFd socket, StreamLimits limits)
    : port_(port),
      socket_(kj::mv(socket)),
      limits_(limits),
      readObserver_(port, socket_, kj::UnixEventPort::FdObserver::OBSERVE_READ),
      opened_(port.getTimer().now()) {}

MessageStream::~MessageStream() noexcept(false) { port_.forget(*this); }

// ---- reading

kj::Promise<kj::Maybe<capnp::MessageReaderAndFds>> MessageStream::tryReadMessage(
    kj::ArrayPtr<kj::AutoCloseFd>, capnp::ReaderOptions options, kj::ArrayPtr<capnp::word>) {
  return kj::evalNow([&] { return read(options); });
}

MessageStream::Reading MessageStream::read(capnp::ReaderOptions options) {
  for (;;) {
    auto message = takeMessage(options);
    if (message != nullptr) return Reading(kj::mv(message));
    if (readable_ != nullptr) return waitAndRead(options);
    if (receive() == Received::End) {
      if (incoming_.bytes().empty()) return Reading(kj::Maybe<capnp::MessageReaderAndFds>(nullptr));
      kj::throwFatalException(disconnected("the peer closed in the middle of a message"));
    }
  }
}

MessageStream::Reading MessageStream::waitAndRead(capnp::ReaderOptions options) {
  auto readable = kj::mv(KJ_ASSERT_NONNULL(readable_));
  readable_ = nullptr;
  KJ_IF_MAYBE (deadline, readDeadline()) {
    readable = readable.exclusiveJoin(port_.getTimer().atTime(*deadline).then([this] {
      kj::throwFatalException(disconnected(anyMessage_ ? "the peer did not finish a message in time"
                                                       : "the peer sent no message in time"));
    }));
  }
  return readable.then([this, options] { return read(options); });
}

kj::Maybe<capnp::MessageReaderAndFds> MessageStream::takeMessage(capnp::ReaderOptions options) {
  const auto bytes = incoming_.bytes();
  const FrameParse parse = parseFrameHeader(bytes, limits_);
  if (parse.fault != FrameFault::None) {
    kj::throwFatalException(disconnected(toString(parse.fault)));
  }
  if (!parse.header || bytes.size() < parse.header->totalBytes) return nullptr;
  anyMessage_ = true;
  partialSince_ = nullptr;
  auto reader =
      kj::heap<ReceivedMessage>(incoming_.take(parse.header->totalBytes), *parse.header, options);
  return capnp::MessageReaderAndFds{kj::mv(reader), nullptr};
}

MessageStream::Received MessageStream::receive() {
  const auto space = incoming_.space();
  const ssize_t count = recv(socket_, space.data(), space.size(), 0);
  if (count == 0) return Received::End;
  if (count < 0 && errno == EINTR) return Received::Some;
  if (count < 0 && errno != EAGAIN) kj::throwFatalException(lost(errno));

  // The socket is known to be empty after EAGAIN, and after a short read unless the end has been
  // seen: then only another receive reports it. An edge that fires while no promise waits is
  // dropped, so make it now.
  bool ended = true;
  KJ_IF_MAYBE (hint, readObserver_.atEndHint()) ended = *hint;
  const bool shortRead = count > 0 && static_cast<std::size_t>(count) < space.size();
  if (count < 0 || (shortRead && !ended)) readable_ = readObserver_.whenBecomesReadable();
  if (count < 0) return Received::Nothing;

  incoming_.arrived(static_cast<std::size_t>(count));
  counters_->receivedBytes.fetch_add(static_cast<std::uint64_t>(count), std::memory_order_relaxed);
  return Received::Some;
}

kj::Maybe<kj::TimePoint> MessageStream::readDeadline() {
  if (!incoming_.bytes().empty()) {
    if (partialSince_ == nullptr) partialSince_ = port_.getTimer().now();
    return KJ_ASSERT_NONNULL(partialSince_) + limits_.partialMilliseconds * kj::MILLISECONDS;
  }
  if (anyMessage_ || limits_.firstMilliseconds == 0) return nullptr;
  return opened_ + limits_.firstMilliseconds * kj::MILLISECONDS;
}

// ---- writing

kj::Promise<void> MessageStream::writeMessage(
    kj::ArrayPtr<const int>, kj::ArrayPtr<const kj::ArrayPtr<const capnp::word>> segments) {
  return write(segments);
}

kj::Promise<void> MessageStream::writeMessages(
    kj::ArrayPtr<kj::ArrayPtr<const kj::ArrayPtr<const capnp::word>>> messages) {
  kj::Promise<void> last = kj::READY_NOW;
  for (auto segments : messages) last = write(segments);
  return last;
}

kj::Promise<void> MessageStream::write(Segments segments) {
  KJ_IF_MAYBE (failed, writeFailure_) return kj::cp(*failed);
  // The bytes are copied, so that the caller may go on and what it writes next leaves in the same
  // send.
  appendFrame(segments, outgoing_);
  if (outgoing_.size() - outgoingBegin_ >= kSendAtOnce) {
    flush();
  } else if (mayWait_ != nullptr && mayWait_(segments)) {
    scheduleRide();
  } else {
    port_.flushBeforeSleep(*this);
  }
  if (outgoing_.size() - outgoingBegin_ < kHighWater) return kj::READY_NOW;
  return whenDrained();
}

// Never cancelled: in steady traffic one timer covers many messages, and finds that they have left.
void MessageStream::scheduleRide() {
  if (rideScheduled_) return;
  rideScheduled_ = true;
  rideTask_ = port_.getTimer()
                  .afterDelay(kLongestRideMilliseconds * kj::MILLISECONDS)
                  .then([this] {
                    rideScheduled_ = false;
                    if (!outgoing_.empty()) port_.flushBeforeSleep(*this);
                  })
                  .eagerlyEvaluate(nullptr);
}

void MessageStream::flush() {
  if (awaitingRoom_) return;
  while (outgoingBegin_ < outgoing_.size()) {
    const ssize_t count = send(socket_, outgoing_.data() + outgoingBegin_,
                               outgoing_.size() - outgoingBegin_, MSG_NOSIGNAL);
    if (count >= 0) {
      outgoingBegin_ += static_cast<std::size_t>(count);
      counters_->sentBytes.fetch_add(static_cast<std::uint64_t>(count), std::memory_order_relaxed);
    } else if (errno == EAGAIN) {
      return awaitRoom();
    } else if (errno != EINTR) {
      return fail(lost(errno));
    }
  }
  drained();
}

void MessageStream::awaitRoom() {
  discardSent();
  awaitingRoom_ = true;
  if (writeObserver_ == nullptr) writeObserver_ = kj::heap<WriteObserver>(port_, socket_);
  roomTask_ = KJ_ASSERT_NONNULL(writeObserver_)
                  ->whenWritable()
                  .then([this] {
                    awaitingRoom_ = false;
                    port_.flushBeforeSleep(*this);
                  })
                  .eagerlyEvaluate([this](kj::Exception&& e) { fail(kj::mv(e)); });
}

void MessageStream::discardSent() {
  outgoing_.erase(outgoing_.begin(),
                  outgoing_.begin() + static_cast<std::ptrdiff_t>(outgoingBegin_));
  outgoingBegin_ = 0;
}

void MessageStream::drained() {
  discardSent();
  if (outgoing_.capacity() > kHighWater) outgoing_.shrink_to_fit();
  for (auto& waiting : awaitingDrain_) waiting->fulfill();
  awaitingDrain_.clear();
}

void MessageStream::fail(kj::Exception exception) {
  for (auto& waiting : awaitingDrain_) waiting->reject(kj::cp(exception));
  awaitingDrain_.clear();
  outgoing_.clear();
  outgoingBegin_ = 0;
  writeFailure_ = kj::mv(exception);
}

kj::Promise<void> MessageStream::whenDrained() {
  auto pair = kj::newPromiseAndFulfiller<void>();
  awaitingDrain_.add(kj::mv(pair.fulfiller));
  return kj::mv(pair.promise);
}

kj::Promise<void> MessageStream::end() {
  KJ_IF_MAYBE (failed, writeFailure_) return kj::cp(*failed);
  port_.flushBeforeSleep(*this);
  return whenDrained().then([this] { shutdown(socket_, SHUT_WR); });
}

kj::Maybe<int> MessageStream::getSendBufferSize() {
  int bytes = 0;
  socklen_t length = sizeof(bytes);
  if (getsockopt(socket_, SOL_SOCKET, SO_SNDBUF, &bytes, &length) != 0) return nullptr;
  return bytes;
}

}  // namespace suture::rpc
