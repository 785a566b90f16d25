#pragma once
// A required interface keeps its connection here, and acts on the loss of it.

#include <suture/base/errors.h>
#include <suture/component/contract/connection_contract.h>
#include <suture/component/contract/interface_info.h>
#include <suture/standard/lifecycle.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace suture {

class Channel;
class Component;
class ProvidedBase;

/// Knows the component that a required interface belongs to, and the connection that it has in this
/// cycle. Belongs to the thread of the component, except where a comment says otherwise.
class Attachment {
 public:
  /// Keeps something that holds for one connection only.
  class User {
   public:
    /// The present connection is about to be given up.
    virtual void leave() {}
    /// Another connection has taken its place, or none has.
    virtual void join() {}

   protected:
    ~User() = default;
  };

  Attachment(Component& owner, std::string_view name, const InterfaceInfo& info)
      : name_(name), owner_(owner), info_(info) {}
  Attachment(const Attachment&) = delete;
  Attachment& operator=(const Attachment&) = delete;

  /// In a constructor: tells `user`, which must live as long, of each change, after those that have
  /// asked before.
  void inform(User& user) { users_.push_back(&user); }
  /// In a constructor: looks at the state table of `own` from now on.
  void watch(ProvidedBase& own);

  /// Any thread.
  const std::string& name() const { return name_; }
  const InterfaceInfo& info() const { return info_; }
  Component& owner() const { return owner_; }

  /// Returns the connection; nullptr if there is none.
  const std::shared_ptr<Channel>& channel() const { return channel_; }
  /// Returns why calls cannot reach the provider now, or 0 if they can.
  Errc unusable();
  /// Returns the same for one command.
  Errc unusable(std::uint16_t command);

  /// Any thread. Sets the next connection, or takes it away if null; adopt() does the rest.
  void attach(std::shared_ptr<Channel> channel);
  /// Returns true if adopt() has something to do.
  bool rewired() const { return incoming_.load(std::memory_order_relaxed) != nullptr; }
  /// Takes over what attach() left.
  void adopt();
  /// Acts on each loss of the provider, once.
  void noticeLoss();
  /// Returns true while the provider is lost and the contract faults its client for that.
  bool lossFaults() const;
  /// Calls adopt() and noticeLoss().
  void update();
  /// Admits commands that await their operator again.
  ResumeOutcome resume();
  /// Gives up the connection, and what attach() left, before anything that uses them ends. Returns
  /// when no direct handler of an event is running.
  void close();
  /// Returns when no direct handler of an event is running.
  void awaitDirectHandlers() const;

 private:
  /// Counts what has been lost so far: two counts are equal if nothing was lost between them.
  std::pair<const void*, std::uint64_t> losses() const;
  bool awaitsOperator(std::uint16_t command) const;

  const std::string name_;
  Component& owner_;
  const InterfaceInfo& info_;
  std::vector<User*> users_;
  std::shared_ptr<Channel> channel_;
  std::atomic<std::shared_ptr<Channel>*> incoming_{nullptr};
  // True once noticeLoss() has dealt with the loss of channel_.
  bool lossNoticed_ = false;
  std::uint32_t faultsNoticed_ = 0;
  std::atomic<bool> resumeAsked_{false};  // used by a device
};

}  // namespace suture
