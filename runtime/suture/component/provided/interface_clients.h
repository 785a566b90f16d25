#pragma once
// A provided interface keeps its clients here, and tells them in which state its component is.

#include <suture/base/errors.h>
#include <suture/component/channel/channel_list.h>
#include <suture/component/channel/channel_status.h>
#include <suture/component/channel/last_invalid.h>
#include <suture/component/contract/interface_info.h>

#include <memory>
#include <string>
#include <string_view>

namespace suture {

class Component;

/// Knows the component that a provided interface belongs to, and the channels of its clients.
/// Belongs to the thread that serves the interface, except where a comment says otherwise.
class InterfaceClients {
 public:
  InterfaceClients(Component& owner, std::string_view name, const InterfaceInfo& info);
  InterfaceClients(const InterfaceClients&) = delete;
  InterfaceClients& operator=(const InterfaceClients&) = delete;

  /// Any thread.
  const std::string& name() const { return name_; }
  const InterfaceInfo& info() const { return info_; }
  Component& owner() const { return owner_; }

  /// Only the thread that serves the interface may walk along them; any thread of a device may.
  const ChannelList& channels() const { return channels_; }
  /// Any thread. Adds a client.
  void add(std::shared_ptr<Channel> channel);
  /// Any thread that may free memory. Lets go of the channels that have ended, if this is a device.
  void sweep();
  /// Lets go of them if this is a task's; to be called when it has been told of their ends.
  void dropEnded();

  /// Before any client is connected: makes the interface serve in every state of its component.
  void serveInEveryState() { everyState_ = true; }
  bool servesInEveryState() const { return everyState_; }
  /// Returns false if commands are refused because the component is suspended or faulted.
  bool inService() const;
  /// Returns the answer to commands that wait, or 0 if they are executed.
  Errc refusal() const;
  /// Any thread. Tells a new client in which state the component is.
  void tellState(Channel& channel) const;
  /// In a thread that may walk along the clients. Tells all of them.
  void announce(ChannelStatus status);

  /// Calls `tell(client, news)` for each client that has come or gone since the last call, if the
  /// component may be told of its clients now.
  template <class Tell>
  void takeNews(const Tell& tell) {
    if (!mayHear()) return;
    channels_.forEach([&](ChannelList::Node& node) {
      ClientNews news{};
      if (takeNewsOf(node, news)) tell(node.client, news);
    });
  }
  /// Returns true if commands, subscribers or news of clients are waiting.
  bool pending() const;
  /// Returns true if commands of this component are waiting: "console:Teleop".
  bool pendingFrom(std::string_view component) const;

  /// In a thread that may walk along the clients; never allocates. Notes which part of a value the
  /// contract did not admit. `asker` is the client that does not get it; null means all clients.
  void noteInvalid(const FieldPath& path, Channel* asker);
  /// Any thread; never allocates.
  FieldPath lastInvalid() const { return lastInvalid_.read(); }

 private:
  bool mayHear() const;
  static bool isNews(const ChannelList::Node& node);
  static bool takeNewsOf(ChannelList::Node& node, ClientNews& news);

  const std::string name_;
  Component& owner_;
  const InterfaceInfo& info_;
  ChannelList channels_;
  bool everyState_ = false;
  LastInvalid lastInvalid_;
};

}  // namespace suture
