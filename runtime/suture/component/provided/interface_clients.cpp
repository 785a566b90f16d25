#include <suture/component/channel/channel.h>
#include <suture/component/component.h>
#include <suture/component/provided/interface_clients.h>

#include <utility>

namespace suture {

InterfaceClients::InterfaceClients(Component& owner, std::string_view name,
                                   const InterfaceInfo& info)
    : name_(name),
      owner_(owner),
      info_(info),
      channels_(owner.ownsThread() ? ChannelList::Walkers::Owner : ChannelList::Walkers::Any) {}

void InterfaceClients::add(std::shared_ptr<Channel> channel) {
  sweep();
  channels_.add(std::move(channel));
}

void InterfaceClients::sweep() {
  if (!owner_.ownsThread()) channels_.sweep();
}

void InterfaceClients::dropEnded() {
  if (!owner_.ownsThread() || !channels_.unlinkClosed()) return;
  owner_.ringNow();  // a bell that is due may go with its channel
  channels_.letGo();
}

bool InterfaceClients::inService() const {
  return everyState_ || statusIn(owner_.state()) == ChannelStatus::Connected;
}

Errc InterfaceClients::refusal() const {
  if (owner_.ending()) return Errc::Lost;
  return inService() ? Errc{} : errorOf(statusIn(owner_.state()));
}

// Repeats until the state stays, because a thread that announces a change may not have seen the
// channel yet.
void InterfaceClients::tellState(Channel& channel) const {
  if (everyState_) return;
  ComponentState told;
  do {
    told = owner_.state();
    channel.tell(statusIn(told));
  } while (owner_.state() != told);
}

void InterfaceClients::announce(ChannelStatus status) {
  if (everyState_ && status != ChannelStatus::Lost) return;
  channels_.forEach([status](ChannelList::Node& node) { node.channel->tell(status); });
}

bool InterfaceClients::mayHear() const {
  return owner_.state() == ComponentState::Running && !owner_.ending();
}

// Skips local clients of a device, which come and go in their own threads.
bool InterfaceClients::isNews(const ChannelList::Node& node) {
  if (node.channel->ends.device != nullptr) return false;
  const bool over = isOver(node.channel->status.load(std::memory_order_seq_cst));
  return over == node.known.load(std::memory_order_relaxed);
}

// Marks a client as known before it reads the status, so that a thread that removes closed channels
// meanwhile leaves those that the component knows of.
bool InterfaceClients::takeNewsOf(ChannelList::Node& node, ClientNews& news) {
  if (!isNews(node)) return false;
  const bool known = node.known.exchange(true, std::memory_order_seq_cst);
  const ChannelStatus status = node.channel->status.load(std::memory_order_seq_cst);
  const bool over = isOver(status);
  if (over) node.known.store(false, std::memory_order_seq_cst);
  if (known != over) return false;  // the client has come and gone
  const ClientNews end = status == ChannelStatus::Lapsed ? ClientNews::Silent : ClientNews::Closed;
  news = over ? end : ClientNews::Connected;
  return true;
}

bool InterfaceClients::pendingFrom(std::string_view component) const {
  bool any = false;
  channels_.forEach([&any, component](ChannelList::Node& node) {
    const Channel& channel = *node.channel;
    any = any ||
          (channel.commands.pending() && Channel::componentOf(channel.clientName()) == component);
  });
  return any;
}

bool InterfaceClients::pending() const {
  bool any = false;
  channels_.forEach([&any, hears = mayHear()](ChannelList::Node& node) {
    const Channel& channel = *node.channel;
    const bool newcomer = channel.provider.joining() && channel.ends.device == nullptr;
    any = any || newcomer || channel.commands.pending() || (hears && isNews(node));
  });
  return any;
}

void InterfaceClients::noteInvalid(const FieldPath& path, Channel* asker) {
  lastInvalid_.note(path);
  if (asker != nullptr) return asker->lastInvalid.note(path);
  channels_.forEach([&path](ChannelList::Node& node) { node.channel->lastInvalid.note(path); });
}

}  // namespace suture
