#pragma once
// This tells a provider how old commands are, also if the machine was suspended meanwhile.

#include <suture/base/boot_time.h>
#include <suture/base/time.h>

namespace suture {

/// The thread that serves an interface. Stamps are of the steady clock, which stands still while
/// the machine is suspended, so an age by it lacks that time. The clock that goes on then is read
/// instead, and both are compared when a drain begins: if the other has gained, the machine has
/// slept since the last drain. Commands with stamps from before that was noticed are taken for
/// older by the sleep, also those that were sent between it and the drain, because nothing tells
/// them apart.
class CommandClock {
 public:
  CommandClock();

  /// A drain begins.
  void begin();
  /// Reads the clock again, because a handler may have taken long.
  void look() { present_ = BootClock::now(); }
  /// Returns when either was called last.
  const BootTime& present() const { return present_; }
  /// Returns how old a command with this stamp was then.
  Duration age(Time stamp) const {
    const Duration awake = present_.time_since_epoch() - ahead_ - stamp.time_since_epoch();
    return stamp <= noticed_ ? awake + slept_ : awake;
  }

 private:
  /// Returns by how much the clock that goes on is ahead of the steady one, at least: a pause
  /// between the two reads makes it less.
  Duration compare(Time& steady);

  BootTime present_{};
  Duration ahead_{0};  // the most that compare() has found
  Time noticed_{};     // when the last sleep was noticed
  Duration slept_{0};  // how long it was, with those just before it
};

}  // namespace suture
