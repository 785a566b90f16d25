#pragma once
// A provided interface emits its events here, and gives newcomers the last values of those that are
// latched.

#include <suture/base/errors.h>
#include <suture/base/time.h>
#include <suture/component/channel/channel_list.h>
#include <suture/component/provided/interface_clients.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace suture {

/// A task's events belong to its own thread; any thread may emit a device's.
class EventEmission {
 public:
  explicit EventEmission(InterfaceClients& clients);
  ~EventEmission();
  EventEmission(const EventEmission&) = delete;
  EventEmission& operator=(const EventEmission&) = delete;

  /// Returns true in a thread that may not walk the channels and fill the subscribers' queues.
  bool inWrongThread() const;
  /// Gives each subscriber of `event` the payload in `slot`, which store() found to fit if `fits`.
  /// Answers Errc::WrongThread, or what judge() does, and then no subscriber gets it.
  Errc emit(std::uint16_t event, const std::byte* slot, bool fits);
  /// Returns why no subscriber may get such a payload, or 0.
  Errc judge(std::uint16_t event, const std::byte* slot, bool fits);

  /// In a thread that may emit: returns the only subscriber of `event`, if its queue is where the
  /// event goes; else nullptr.
  std::shared_ptr<Channel> onlySubscriber(std::uint16_t event) const;
  /// Emits what EventQueue::lend() of `channel` gave.
  void deliverLent(Channel& channel, std::uint16_t event, std::byte* payload);

  /// In the thread that serves the interface; does nothing for a local client of a device. Lets a
  /// client hear from now on what it has subscribed to, and gives it the last values of what is new
  /// to it.
  void greet(ChannelList::Node& node);
  /// Any thread, for a local client of a device, which has no cycle: gives a client that has just
  /// subscribed the last values. Does nothing for others.
  void greetLocal(Channel& channel);

 private:
  /// Calls `visit(channel, direct)` for each subscriber of `event`; `direct` is true for one whose
  /// handler runs in the thread that emits.
  template <class Visit>
  void forEachSubscriber(std::uint16_t event, const Visit& visit) const;
  void deliver(Channel& channel, std::uint16_t event, Time stamp,
               std::span<const std::byte> payload, bool direct);
  void replay(Channel& channel, EventSet events, std::span<std::uint64_t> memory);
  void replay(Channel& channel, std::uint16_t event, std::span<std::uint64_t> memory);
  void keepLatched(std::uint16_t event, Time stamp, std::span<const std::byte> payload);

  InterfaceClients& clients_;
  struct Latched;
  std::vector<std::unique_ptr<Latched>> latched_;  // by event; null if it is not latched
  std::vector<std::uint64_t> replayed_;            // one payload, for the thread that serves
};

}  // namespace suture
