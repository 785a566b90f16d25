#pragma once
// This lists the channels of one provided interface.

#include <suture/component/channel/connected_client.h>
#include <suture/component/contract/interface_info.h>

#include <atomic>
#include <cstdint>
#include <memory>

namespace suture {

class Channel;

/// Any thread may add. The next walk sees what is added during a walk. Walking takes no lock and
/// allocates nothing.
class ChannelList {
 public:
  /// Says which threads walk and sweep.
  enum class Walkers : std::uint8_t {
    Owner,  ///< one thread does both, such as that of a task
    Any,    ///< any thread walks, also several at a time; any that may free memory sweeps
  };

  struct Node {
    std::shared_ptr<Channel> channel;
    const ConnectedClient client;
    /// The thread that serves the channel writes it: true while the component has been told of the
    /// client, and not yet that it is gone. Until then no sweep removes the node.
    std::atomic<bool> known{false};
    std::atomic<Node*> next{nullptr};
    /// The owner of the list sends these events there: none before its first cycle with it.
    EventSet served = 0;
    EventSet direct = 0;  ///< those that have a direct handler
    Node* nextUnlinked = nullptr;
  };

  explicit ChannelList(Walkers walkers);
  ~ChannelList();
  ChannelList(const ChannelList&) = delete;
  ChannelList& operator=(const ChannelList&) = delete;

  void add(std::shared_ptr<Channel> channel);

  template <class Visit>
  void forEach(const Visit& visit) const {
    const Walk walk(*this);
    // This load is in one order with add(): see Component::setState().
    for (Node* node = head_.load(std::memory_order_seq_cst); node != nullptr;
         node = node->next.load(std::memory_order_acquire)) {
      visit(*node);
    }
  }

  bool empty() const { return head_.load(std::memory_order_acquire) == nullptr; }

  /// For Walkers::Owner. Removes closed channels whose end the component knows. Returns true if
  /// there are any; then call letGo().
  bool unlinkClosed();
  /// For Walkers::Owner. Deletes what unlinkClosed() has removed.
  void letGo();
  /// For Walkers::Any. While others walk, it deletes what an earlier sweep has found, at the latest
  /// when a later sweep meets no walk. During another sweep it does nothing.
  void sweep();

 private:
  void unlink(Node* node);

  /// While one exists, no node is deleted that it may stand on.
  class Walk {
   public:
    explicit Walk(const ChannelList& list) : list_(list) {
      if (list_.walkers_ == Walkers::Any) list_.walking_.fetch_add(1, std::memory_order_acq_rel);
    }
    ~Walk() {
      if (list_.walkers_ == Walkers::Any) list_.walking_.fetch_sub(1, std::memory_order_acq_rel);
    }
    Walk(const Walk&) = delete;
    Walk& operator=(const Walk&) = delete;

   private:
    const ChannelList& list_;
  };

  const Walkers walkers_;
  std::atomic<Node*> head_{nullptr};
  mutable std::atomic<unsigned> walking_{0};      // for Walkers::Any
  std::atomic_flag sweeping_ = ATOMIC_FLAG_INIT;  // for Walkers::Any
  Node* unlinked_ = nullptr;
};

}  // namespace suture
