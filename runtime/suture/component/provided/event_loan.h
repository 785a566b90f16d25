#pragma once
// This is the memory from which an event leaves, on loan to who emits it.

#include <suture/base/errors.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace suture {

class Channel;
class EventEmission;

/// Belongs to the thread that emits the event, and lasts no longer than its filling. An event that
/// leaves at once for several subscribers, or for none, cannot be written where it leaves from.
class EventLoan {
 public:
  EventLoan(EventEmission& emission, std::uint16_t event);
  /// Gives the memory up unless it has been emitted.
  ~EventLoan();
  EventLoan(const EventLoan&) = delete;
  EventLoan& operator=(const EventLoan&) = delete;

  /// Returns room for the payload's slot in the queue of the only subscriber; nullptr if the
  /// payload must be made elsewhere and emitted as any other.
  std::byte* memory() const { return memory_; }
  /// Emits what memory() holds, or answers Errc::TooLarge or Errc::Invalid as Emitter does.
  Errc emit(bool fits);

 private:
  EventEmission& emission_;
  const std::uint16_t event_;
  std::shared_ptr<Channel> subscriber_;
  std::byte* memory_ = nullptr;
};

}  // namespace suture
