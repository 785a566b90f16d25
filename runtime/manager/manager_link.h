#pragma once
// A process's connection to the global manager.

#include <suture/manager/records.h>
#include <suture/transport/rpc/address.h>
#include <suture/transport/rpc/control_thread.h>
#include <suture/transport/rpc/link.h>
#include <suture/transport/rpc/secure.h>

#include <atomic>
#include <string>
#include <vector>

namespace suture {

/// Talks to the global manager and, once enrolled, keeps the process known: if the manager goes
/// away it comes back to it, or to its successor, as often as needed. Belongs to the control
/// thread; outlives its promises.
class ManagerLink {
 public:
  ManagerLink(rpc::ControlThread& control, const rpc::Address& manager, std::string program,
              rpc::Trust trust = {});

  /// Reaches the manager, trying again for `patience`. Rejects with what was found and what to do.
  kj::Promise<void> open(Duration patience);
  /// Registers this process. Rejects if the name is taken.
  kj::Promise<void> enrol(ProcessRecord process);
  /// Tells what the process offers and needs now.
  void update(std::vector<ComponentRecord> components);

  /// Where a process is, waiting for it at most `wait`. Rejects with what the manager knows.
  kj::Promise<ProcessRecord> resolve(const std::string& process, Duration wait);
  kj::Promise<std::vector<ProcessRecord>> list();

  const rpc::Address& address() const { return manager_; }
  /// Once open: where peers of the network of the manager reach this machine; port 0.
  const rpc::Address& here() const { return here_; }
  /// A stream to a process that the manager knows, no less safe than this link: what the manager
  /// was told by others does not lead out of TLS.
  kj::Promise<rpc::ByteStream> reach(const ProcessRecord& process, Duration deadline);
  /// Any thread: the manager answers and knows this process.
  bool enrolled() const { return enrolled_.load(std::memory_order_relaxed); }

 private:
  kj::Promise<void> connect();
  kj::Promise<void> enrolAgain();
  kj::Promise<void> keep();
  kj::Promise<void> comeBack(Duration pause);

  rpc::ControlThread& control_;
  const rpc::Address manager_;
  const std::string program_;
  const rpc::Trust trust_;
  rpc::Address here_;
  kj::Maybe<kj::Own<rpc::Link>> link_;
  kj::Maybe<wire::Session::Client> session_;
  kj::Maybe<wire::Lease::Client> lease_;
  ProcessRecord process_;
  std::atomic<bool> enrolled_{false};
  kj::Promise<void> keeping_ = kj::READY_NOW;  // last: cancelled first
};

}  // namespace suture
