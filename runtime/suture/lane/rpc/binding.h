#pragma once
// What suturec writes for each contract so that it can travel over Cap'n Proto RPC. Everything here
// belongs to the control thread.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/capability.h>
#include <capnp/schema.h>
#include <suture/component/channel/channel.h>
#include <suture/rt/queue/mailbox.h>

#include <cstddef>
#include <cstdint>

namespace suture::rpc {

/// A call of any method, as Cap'n Proto hands it to a capability.
using AnyCall = capnp::CallContext<capnp::AnyPointer, capnp::AnyPointer>;

/// The number of a command or an event in tables and records.
template <class Name>
constexpr std::uint16_t numberOf(Name name) {
  return static_cast<std::uint16_t>(name);
}

class ProxyPort;
class ServantPort;

/// The far end of a subscription, as the provider's side sees it: turns slots into typed calls.
class EventSink {
 public:
  virtual ~EventSink() noexcept(false) = default;
  /// Sends event `event`; the promise resolves when the subscriber has taken it.
  virtual kj::Promise<void> event(std::uint16_t event, const std::byte* payload) = 0;
  /// Sends the columns in `row.valid`; `columns[i]` is the slot of column i.
  virtual kj::Promise<void> row(const rt::StateTable::Row& row,
                                std::span<const std::byte* const> columns) = 0;
};

/// The far end of a connection, as the client's side sees it: turns command records into typed
/// calls.
class Proxy {
 public:
  virtual ~Proxy() noexcept(false) = default;
  /// Sends one command. The promise resolves when the call has returned and, if the record asked
  /// for an answer, the result has been given to ProxyPort::answer(). Rejects with remoteError() or
  /// as a broken link does.
  virtual kj::Promise<void> send(const rt::CommandRecord& record) = 0;
  /// Asks for these events and columns, in place of what was asked for before.
  virtual kj::Promise<void> subscribe(EventSet events, rt::ColumnSet columns) = 0;
};

/// The factory of all three, one object a contract with static storage.
class Binding {
 public:
  /// Serves the contract's own capability through `port`.
  virtual kj::Own<capnp::Capability::Server> makeServant(kj::Own<ServantPort> port) const = 0;
  /// Speaks to `contract`, which must be of the contract's interface. `port` outlives it.
  virtual kj::Own<Proxy> makeProxy(capnp::Capability::Client contract, ProxyPort& port) const = 0;
  /// Speaks to `subscriber`, which must be of the contract's events interface.
  virtual kj::Own<EventSink> makeSink(capnp::Capability::Client subscriber) const = 0;
  /// Any thread: the contract's own interface; its events interface is what `subscribe` takes.
  virtual capnp::InterfaceSchema schema() const = 0;

 protected:
  ~Binding() = default;
};

}  // namespace suture::rpc
