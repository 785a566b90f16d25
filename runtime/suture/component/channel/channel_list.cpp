#include <suture/component/channel/channel.h>
#include <suture/component/channel/channel_list.h>

#include <utility>

namespace suture {
namespace {

// The sequentially consistent loads are in one order with InterfaceClients::takeNewsOf(), which
// sets `known` before it reads the status.
bool mayGo(const ChannelList::Node& node) {
  return node.channel->status.load(std::memory_order_seq_cst) == ChannelStatus::Closed &&
         !node.known.load(std::memory_order_seq_cst);
}

}  // namespace

ChannelList::ChannelList(Walkers walkers) : walkers_(walkers) {}

ChannelList::~ChannelList() {
  letGo();
  Node* node = head_.load(std::memory_order_acquire);
  while (node != nullptr) {
    Node* next = node->next;
    delete node;
    node = next;
  }
}

void ChannelList::add(std::shared_ptr<Channel> channel) {
  const std::string_view client = channel->clientName();
  const Duration silence = channel->ends.silence;
  auto* node = new Node{std::move(channel), ConnectedClient(client, silence)};
  Node* next = head_.load(std::memory_order_relaxed);
  do {
    node->next.store(next, std::memory_order_relaxed);
  } while (!head_.compare_exchange_weak(next, node, std::memory_order_seq_cst,
                                        std::memory_order_relaxed));
}

void ChannelList::sweep() {
  if (sweeping_.test_and_set(std::memory_order_acquire)) return;
  unlinkClosed();
  // If no thread walks now, one that begins later does not find these nodes, so they may be
  // deleted.
  if (walking_.fetch_add(0, std::memory_order_acq_rel) == 0) letGo();
  sweeping_.clear(std::memory_order_release);
}

// Only a sweeper changes what is behind the head; a new node may join at the head at any time.
bool ChannelList::unlinkClosed() {
  Node* head = head_.load(std::memory_order_acquire);
  if (head == nullptr) return false;
  for (Node* node = head; Node* next = node->next.load(std::memory_order_relaxed);) {
    if (mayGo(*next)) {
      node->next.store(next->next.load(std::memory_order_relaxed), std::memory_order_release);
      unlink(next);
    } else {
      node = next;
    }
  }
  Node* const second = head->next.load(std::memory_order_relaxed);
  if (mayGo(*head) && head_.compare_exchange_strong(head, second)) unlink(head);
  return unlinked_ != nullptr;
}

void ChannelList::unlink(Node* node) { node->nextUnlinked = std::exchange(unlinked_, node); }

void ChannelList::letGo() {
  while (unlinked_ != nullptr) {
    const std::unique_ptr<Node> node(std::exchange(unlinked_, unlinked_->nextUnlinked));
  }
}

}  // namespace suture
