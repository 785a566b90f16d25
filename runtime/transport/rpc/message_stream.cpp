#include <suture/transport/rpc/message_stream.h>

#include <suture/transport/rpc/failure.h>
#include <suture/transport/rpc/received_message.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>

namespace suture::rpc {
namespace {

// This much is worth a send of its own.
constexpr std::size_t kSendAtOnce = 1u << 16;
// A buffer that has grown beyond this is given back when it is empty.
constexpr std::size_t kKept = 1u << 20;

capnp::ReaderOptions readerOptions(const StreamLimits& limits) {
  capnp::ReaderOptions options;
  options.traversalLimitInWords = limits.messageBytes / sizeof(capnp::word);
  return options;
}

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

MessageStream::Reading MessageStream::read() {
  return kj::evalNow([this] { return readBuffered(); });
}

MessageStream::Reading MessageStream::readBuffered() {
  for (;;) {
    auto message = takeMessage();
    if (message != nullptr) return Reading(kj::mv(message));
    if (readable_ != nullptr) return waitAndRead();
    if (receive() == Received::End) {
      if (incoming_.bytes().empty())
        return Reading(kj::Maybe<kj::Own<capnp::IncomingRpcMessage>>(nullptr));
      kj::throwFatalException(disconnected("the peer closed in the middle of a message"));
    }
  }
}

MessageStream::Reading MessageStream::waitAndRead() {
  auto readable = kj::mv(KJ_ASSERT_NONNULL(readable_));
  readable_ = nullptr;
  KJ_IF_MAYBE (deadline, readDeadline()) {
    readable = readable.exclusiveJoin(port_.getTimer().atTime(*deadline).then([this] {
      kj::throwFatalException(disconnected(anyMessage_ ? "the peer did not finish a message in time"
                                                       : "the peer sent no message in time"));
    }));
  }
  return readable.then([this] { return readBuffered(); });
}

kj::Maybe<kj::Own<capnp::IncomingRpcMessage>> MessageStream::takeMessage() {
  const auto bytes = incoming_.bytes();
  const FrameParse parse = parseFrameHeader(bytes, limits_);
  if (parse.fault != FrameFault::None) {
    kj::throwFatalException(disconnected(toString(parse.fault)));
  }
  if (!parse.header || bytes.size() < parse.header->totalBytes) return nullptr;
  anyMessage_ = true;
  partialSince_ = nullptr;
  return kj::Own<capnp::IncomingRpcMessage>(kj::heap<ReceivedMessage>(
      incoming_.take(parse.header->totalBytes), *parse.header, readerOptions(limits_)));
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

void MessageStream::write(Segments message, Leaves when) {
  if (writeFailure_ != nullptr) return;
  // The bytes are copied, so that what is written next leaves in the same send.
  appendFrame(message, outgoing_);
  const std::size_t unsent = outgoing_.size() - outgoingBegin_;
  if (unsent > limits_.unsentBytes) {
    fail(disconnected("the peer does not take what is sent"));
  } else if (unsent >= kSendAtOnce) {
    flush();
  } else if (when == Leaves::WithTheNext) {
    scheduleRide();
  } else {
    port_.flushBeforeSleep(*this);
  }
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
  if (outgoing_.capacity() > kKept) outgoing_.shrink_to_fit();
  KJ_IF_MAYBE (waiting, ending_) (*waiting)->fulfill();
}

// The reader hears of it from the socket.
void MessageStream::fail(kj::Exception exception) {
  shutdown(socket_, SHUT_RDWR);
  KJ_IF_MAYBE (waiting, ending_) (*waiting)->reject(kj::cp(exception));
  outgoing_.clear();
  outgoingBegin_ = 0;
  writeFailure_ = kj::mv(exception);
}

kj::Promise<void> MessageStream::end() {
  KJ_IF_MAYBE (failed, writeFailure_) return kj::cp(*failed);
  auto pair = kj::newPromiseAndFulfiller<void>();
  ending_ = kj::mv(pair.fulfiller);
  port_.flushBeforeSleep(*this);
  return pair.promise.then([this] { shutdown(socket_, SHUT_WR); });
}

}  // namespace suture::rpc
