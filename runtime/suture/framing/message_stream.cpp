#include <suture/framing/message_stream.h>

#include <suture/framing/received_message.h>
#include <suture/loop/deadline.h>
#include <suture/loop/failure.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <span>

namespace suture::framing {
namespace {

// From this many bytes on, what waits is sent at once, and not together with later messages.
constexpr std::size_t kSendAtOnce = 1u << 16;
// A buffer that has grown beyond this is freed when it is empty. An image fits, because otherwise
// the kernel would clear the memory of each image anew.
constexpr std::size_t kKept = 4u << 20;

// These are how many bytes are read at once from a peer that is known, and from a stranger.
constexpr std::size_t kReadAtOnce = 64u << 10;
constexpr std::size_t kStrangersReadAtOnce = 4u << 10;

constexpr const char* kTooLongOfStranger =
    "the peer announces a message too long for one that has not said who it is";
constexpr const char* kTakesNothing = "the peer does not take what is sent";
constexpr const char* kOtherSpeaksTls =
    "it speaks TLS, and this end does not. Correct the address: tls:// at both ends, or at "
    "neither.";

// Cap'n Proto counts what a reference leads to each time that it is followed, and generated code
// follows some references twice.
capnp::ReaderOptions readerOptions(const StreamLimits& limits) {
  capnp::ReaderOptions options;
  options.traversalLimitInWords = 2 * limits.messageBytes / sizeof(capnp::word);
  return options;
}

// Returns true for the first bytes of a ClientHello or of an alert.
bool isTls(std::span<const std::byte> bytes) {
  return bytes.size() >= 2 && (bytes[0] == std::byte{0x16} || bytes[0] == std::byte{0x15}) &&
         bytes[1] == std::byte{0x03};
}

}  // namespace

MessageStream::MessageStream(loop::EventPort& port, net::ByteStream bytes, StreamLimits limits,
                             std::span<const std::byte> begun, StrangerGuard guard)
    : port_(port),
      bytes_(kj::mv(bytes)),
      limits_(limits),
      guard_(std::move(guard)),
      readObserver_(port, bytes_.socket(), loop::EventPort::FdObserver::OBSERVE_READ),
      incoming_(guard_.known == nullptr ? kReadAtOnce : kStrangersReadAtOnce),
      opened_(port.getTimer().now()) {
  if (begun.empty()) return;
  std::copy(begun.begin(), begun.end(), incoming_.space().begin());
  incoming_.arrived(begun.size());
  counters_->receivedBytes = begun.size();
}

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
      kj::throwFatalException(loop::disconnected("the peer closed in the middle of a message"));
    }
  }
}

MessageStream::Reading MessageStream::waitAndRead() {
  auto readable = kj::mv(KJ_ASSERT_NONNULL(readable_));
  readable_ = nullptr;
  KJ_IF_MAYBE (deadline, readDeadline()) {
    readable = loop::unlessLate(port_.getTimer(), *deadline, kj::mv(readable), [this] {
      refuse(incoming_.bytes().empty() ? kSentNothing : kFinishedNothing);
    });
  }
  return readable.then([this] { return readBuffered(); });
}

kj::Maybe<kj::Own<capnp::IncomingRpcMessage>> MessageStream::takeMessage() {
  noteWhetherKnown();
  const auto bytes = incoming_.bytes();
  const HeaderParse parse = parseMessageHeader(bytes, limits_);
  if (isStranger() && parse.header && parse.header->totalBytes > limits_.strangerBytes) {
    refuse(kTooLongOfStranger);
  }
  if (parse.fault != HeaderFault::None) {
    refuse(!anyMessage_ && isTls(bytes) ? kOtherSpeaksTls : toString(parse.fault));
  }
  if (!parse.header) return nullptr;
  if (bytes.size() < parse.header->totalBytes) {
    incoming_.expect(parse.header->totalBytes);
    countUnfinished();
    return nullptr;
  }
  anyMessage_ = true;
  partialSince_ = nullptr;
  auto whole = incoming_.take(parse.header->totalBytes);
  countUnfinished();
  kj::Array<kj::AutoCloseFd> descriptors;
  if (!arrivedDescriptors_.empty()) descriptors = arrivedDescriptors_.takeUntil(taken());
  kj::Own<capnp::IncomingRpcMessage> message = kj::heap<ReceivedMessage>(
      kj::mv(whole), *parse.header, readerOptions(limits_), kj::mv(descriptors));
  const std::string_view broken = judge_(*message, isStranger());
  if (!broken.empty()) refuse(std::string(broken));
  return kj::mv(message);
}

// Counts the bytes of a message that has begun before it waits for more, because a peer may send a
// part and then nothing for a long time.
void MessageStream::countUnfinished() {
  if (guard_.share == nullptr) return;
  const auto beyond = guard_.share->hold(incoming_.longBytes());
  if (beyond) refuse(unfinishedBeyond(*beyond));
}

void MessageStream::refuse(std::string why) {
  refusal_ = std::move(why);
  kj::throwFatalException(loop::disconnected(refusal_));
}

bool MessageStream::isStranger() const { return guard_.known != nullptr && !*guard_.known; }

// Makes the next reads larger as soon as the peer is known.
void MessageStream::noteWhetherKnown() {
  if (guard_.known == nullptr || isStranger()) return;
  guard_.known = nullptr;
  incoming_.setIdleSize(kReadAtOnce);
}

// Returns how many bytes have been taken out so far.
std::uint64_t MessageStream::taken() const {
  return counters_->receivedBytes.load(std::memory_order_relaxed) - incoming_.bytes().size();
}

MessageStream::Received MessageStream::receive() {
  const auto space = incoming_.space();
  net::Descriptors descriptors;
  const ssize_t count = bytes_.receive(space, descriptors);
  if (count == 0) return Received::End;
  if (count < 0 && errno == EINTR) return Received::Some;
  if (count < 0 && errno != EAGAIN) kj::throwFatalException(bytes_.lost(errno));

  // The socket is empty after EAGAIN. It is also empty after a short read, unless that ended with
  // descriptors, or the end of the stream has been seen, which only another receive reports. An
  // edge that fires while no promise waits is dropped, so make the promise now.
  bool ended = true;
  KJ_IF_MAYBE (hint, readObserver_.atEndHint()) ended = *hint;
  const bool shortRead = count > 0 && static_cast<std::size_t>(count) < space.size() &&
                         bytes_.shortMeansEmpty() && descriptors.empty();
  if (count < 0 || (shortRead && !ended)) readable_ = readObserver_.whenBecomesReadable();
  if (count < 0) return Received::Nothing;

  incoming_.arrived(static_cast<std::size_t>(count));
  counters_->receivedBytes.fetch_add(static_cast<std::uint64_t>(count), std::memory_order_relaxed);
  if (!descriptors.empty()) {
    const std::uint64_t end = counters_->receivedBytes.load(std::memory_order_relaxed);
    arrivedDescriptors_.add({end - 1, end, kj::mv(descriptors)});
    if (arrivedDescriptors_.size() > net::kMostDescriptors) {
      refuse("the peer sends more descriptors than messages");
    }
  }
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

void MessageStream::write(Segments message, Leaves when, kj::ArrayPtr<const int> descriptors) {
  if (writeFailure_ != nullptr) return;
  const std::uint64_t begin = counters_->sentBytes + outgoing_.size() - outgoingBegin_;
  // The bytes are copied, so that the next messages can leave in the same send.
  appendMessage(message, outgoing_);
  if (descriptors.size() > 0) {
    const std::uint64_t end = counters_->sentBytes + outgoing_.size() - outgoingBegin_;
    outgoingDescriptors_.add({begin, end, net::duplicate(descriptors)});
  }
  const std::size_t unsent = outgoing_.size() - outgoingBegin_;
  if (unsent > (isStranger() ? limits_.strangerBytes : limits_.unsentBytes)) {
    fail(loop::disconnected(kTakesNothing));
  } else if (unsent >= kSendAtOnce) {
    flush();
  } else if (when == Leaves::WithNextMessage) {
    scheduleDelayedSend();
  } else {
    port_.flushBeforeSleep(*this);
  }
}

// Never cancels the timer: in steady traffic one timer covers many messages, which have left by the
// time that it fires.
void MessageStream::scheduleDelayedSend() {
  if (delayedSendScheduled_) return;
  delayedSendScheduled_ = true;
  delayedSendTask_ = port_.getTimer()
                         .afterDelay(kLongestDelayMilliseconds * kj::MILLISECONDS)
                         .then([this] {
                           delayedSendScheduled_ = false;
                           if (!outgoing_.empty()) port_.flushBeforeSleep(*this);
                         })
                         .eagerlyEvaluate(nullptr);
}

void MessageStream::flush() {
  if (awaitingRoom_) return;
  while (outgoingBegin_ < outgoing_.size()) {
    const ssize_t count = sendSome();
    if (count >= 0) {
      outgoingBegin_ += static_cast<std::size_t>(count);
      counters_->sentBytes.fetch_add(static_cast<std::uint64_t>(count), std::memory_order_relaxed);
    } else if (errno == EAGAIN) {
      return awaitRoom();
    } else if (errno != EINTR) {
      return fail(bytes_.lost(errno));
    }
  }
  drained();
}

// A message with descriptors leaves in a send of its own, so that the receiver knows to which
// message they belong.
ssize_t MessageStream::sendSome() {
  const std::span<const std::byte> unsent = std::span(outgoing_).subspan(outgoingBegin_);
  if (outgoingDescriptors_.empty()) return bytes_.send(unsent, {});
  const auto& [begin, end, descriptors] = outgoingDescriptors_.front();
  const std::uint64_t sent = counters_->sentBytes.load(std::memory_order_relaxed);
  if (sent < begin) return bytes_.send(unsent.first(begin - sent), {});
  const ssize_t count = bytes_.send(unsent.first(end - sent), descriptors);
  if (count > 0) outgoingDescriptors_.pop();
  return count;
}

// Moves the unsent bytes only when at least as many have been sent, so that no byte is moved twice.
// A failure ends this stream alone: the loop flushes outside of all promises, so an exception that
// left from here would end the process.
void MessageStream::awaitRoom() {
  if (outgoingBegin_ >= outgoing_.size() / 2) discardSent();
  KJ_IF_MAYBE (failure, kj::runCatchingExceptions([this] { observeRoom(); })) {
    return fail(kj::mv(*failure));
  }
  awaitingRoom_ = true;
  roomTask_ = KJ_ASSERT_NONNULL(writeObserver_)
                  ->whenWritable()
                  .then([this] {
                    awaitingRoom_ = false;
                    port_.flushBeforeSleep(*this);
                  })
                  .eagerlyEvaluate([this](kj::Exception&& e) { fail(kj::mv(e)); });
}

void MessageStream::observeRoom() {
  if (writeObserver_ == nullptr)
    writeObserver_ = kj::heap<loop::WriteObserver>(port_, bytes_.socket());
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

// The reader gets the error from the socket.
void MessageStream::fail(kj::Exception exception) {
  bytes_.cut();
  KJ_IF_MAYBE (waiting, ending_) (*waiting)->reject(kj::cp(exception));
  outgoing_.clear();
  outgoingBegin_ = 0;
  outgoingDescriptors_ = {};
  writeFailure_ = kj::mv(exception);
}

kj::Promise<void> MessageStream::end() {
  KJ_IF_MAYBE (failed, writeFailure_) return kj::cp(*failed);
  auto pair = kj::newPromiseAndFulfiller<void>();
  ending_ = kj::mv(pair.fulfiller);
  port_.flushBeforeSleep(*this);
  return loop::unlessLate(port_.getTimer(), std::chrono::milliseconds(limits_.drainMilliseconds),
                          pair.promise.then([this] { bytes_.end(); }),
                          [this]() -> kj::Promise<void> {
                            fail(loop::disconnected(kTakesNothing));
                            return kj::cp(KJ_ASSERT_NONNULL(writeFailure_));
                          });
}

}  // namespace suture::framing
