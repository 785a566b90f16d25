#include <suture/component/channel.h>
#include <suture/component/channel_list.h>

namespace suture {
namespace {

bool isClosed(const ChannelList::Node& node) {
  return node.channel->status.load(std::memory_order_acquire) == ChannelStatus::Closed;
}

}  // namespace

ChannelList::~ChannelList() {
  Node* node = head_.load(std::memory_order_acquire);
  while (node != nullptr) {
    Node* next = node->next;
    delete node;
    node = next;
  }
}

void ChannelList::add(std::shared_ptr<Channel> channel) {
  auto* node = new Node{std::move(channel)};
  node->next = head_.load(std::memory_order_relaxed);
  while (!head_.compare_exchange_weak(node->next, node, std::memory_order_seq_cst,
                                      std::memory_order_relaxed)) {
  }
}

void ChannelList::sweep() {
  // Nodes behind the head are the owner's alone; the head may be joined by a new one at any time.
  Node* head = head_.load(std::memory_order_acquire);
  if (head == nullptr) return;
  for (Node* node = head; node->next != nullptr;) {
    Node* next = node->next;
    if (isClosed(*next)) {
      node->next = next->next;
      delete next;
    } else {
      node = next;
    }
  }
  if (isClosed(*head) && head_.compare_exchange_strong(head, head->next)) delete head;
}

}  // namespace suture
