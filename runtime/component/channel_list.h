#pragma once
// The channels of one provided interface.

#include <atomic>
#include <memory>

namespace suture {

class Channel;

/// Any thread may add; one owner thread walks and sweeps. What is added during a walk is seen by
/// the next one. Walking takes no lock and allocates nothing.
class ChannelList {
 public:
  struct Node {
    std::shared_ptr<Channel> channel;
    Node* next = nullptr;
    bool greeted = false;  ///< the owner has seen it
  };

  ChannelList() = default;
  ~ChannelList();
  ChannelList(const ChannelList&) = delete;
  ChannelList& operator=(const ChannelList&) = delete;

  void add(std::shared_ptr<Channel> channel);

  template <class Visit>
  void forEach(const Visit& visit) const {
    // In one order with add(): see Component::setState().
    for (Node* node = head_.load(std::memory_order_seq_cst); node != nullptr; node = node->next) {
      visit(*node);
    }
  }

  bool empty() const { return head_.load(std::memory_order_acquire) == nullptr; }

  /// Owner: lets go of closed channels.
  void sweep();

 private:
  std::atomic<Node*> head_{nullptr};
};

}  // namespace suture
