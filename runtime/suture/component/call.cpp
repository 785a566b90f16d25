#include <suture/component/call.h>

#include <utility>

namespace suture {

CallBase::CallBase(CallBase&& other) noexcept
    : calls_(other.calls_),
      pending_(std::exchange(other.pending_, nullptr)),
      limit_(other.limit_) {}

CallBase& CallBase::operator=(CallBase&& other) noexcept {
  if (this == &other) return *this;
  close();
  calls_ = other.calls_;
  pending_ = std::exchange(other.pending_, nullptr);
  limit_ = other.limit_;
  return *this;
}

bool CallBase::done() { return pending_ != nullptr && calls_->isDone(*pending_); }

void CallBase::close() {
  if (pending_ != nullptr) calls_->close(*std::exchange(pending_, nullptr));
}

bool CallBase::takeBack() {
  if (!calls_->cancel(*pending_)) return false;
  close();
  return true;
}

Errc CallBase::giveUp() {
  const bool stops = !calls_->mayWait();
  if (stops && takeBack()) return Errc::Cancelled;
  if (!stops) calls_->noteTimeout();
  close();
  return stops ? Errc::OutcomeUnknown : Errc::Timeout;
}

void CallBase::passOnTo(PendingCall::Follower follower) {
  calls_->follow(*std::exchange(pending_, nullptr), follower);
}

}  // namespace suture
