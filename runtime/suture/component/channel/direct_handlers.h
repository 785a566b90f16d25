#pragma once
// These handlers of one subscriber run in the thread that emits.

#include <suture/rt/doorbell.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace suture {

class Component;

/// The subscriber's thread sets and clears; any thread calls. Calling takes no lock and allocates
/// nothing. What has been replaced is deleted once no call is under way, as in ChannelList.
class DirectHandlers {
 public:
  using Handler = std::function<void(const std::byte*)>;

  explicit DirectHandlers(std::size_t events) : handlers_(events) {}
  ~DirectHandlers();
  DirectHandlers(const DirectHandlers&) = delete;
  DirectHandlers& operator=(const DirectHandlers&) = delete;

  /// Subscriber's thread. Calls `handler`, of `owner`, from now on, or none if it is null. A call
  /// of the previous handler may be under way.
  void set(std::uint16_t event, Component& owner, std::shared_ptr<const Handler> handler);
  void clear();
  /// Subscriber's thread, not in a task's cycle. Returns when no call is under way.
  void awaitCalls() const;

  /// Any thread. Returns the events that have a handler.
  std::uint64_t events() const { return events_.load(std::memory_order_relaxed); }
  /// Any thread. Runs the handler; if that throws, it parks its component. Returns false if there
  /// is none, or if its component is not running.
  bool call(std::uint16_t event, const std::byte* payload) const;

 private:
  class Calling;
  struct Entry {
    Component& owner;
    std::shared_ptr<const Handler> handler;
  };

  void replace(std::uint16_t event, Entry* entry);

  std::vector<std::atomic<Entry*>> handlers_;  // by event
  std::atomic<std::uint64_t> events_{0};
  mutable std::atomic<unsigned> calling_{0};
  mutable std::atomic<bool> awaited_{false};
  mutable rt::Doorbell returned_;  // rung by calls that end while they are awaited
  std::vector<std::unique_ptr<Entry>> replaced_;
};

}  // namespace suture
