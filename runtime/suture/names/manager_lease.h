#pragma once
// This is a process's registration at one of the global managers.

#include <suture/framing/link.h>
#include <suture/loop/control_thread.h>
#include <suture/names/records.h>
#include <suture/net/address.h>
#include <suture/net/host_lookup.h>
#include <suture/net/secure.h>

#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace suture {

/// Belongs to the control thread; outlives its promises. Talks to a global manager and, once
/// enrolled, keeps the process known there: it renews its lease, and comes back to a manager that
/// was gone or silent, or to its successor, as often as needed.
class ManagerLease {
 public:
  /// Told when trouble() changes. That the process is registered for the first time is no news, nor
  /// is that a manager has not been there yet.
  using News = std::function<void(const net::Address& manager, const std::string& trouble)>;

  ManagerLease(loop::ControlThread& control, const net::Address& manager, std::string program,
               net::Trust trust, News news);

  const net::Address& address() const { return manager_; }
  /// Once open: returns where peers of the network of the manager reach this machine, with port 0.
  const net::Address& here() const { return here_; }

  /// Reaches the manager. Rejects with what was found and what to do, as DISCONNECTED if trying
  /// again may help.
  kj::Promise<void> open();
  /// Returns true while the manager answers.
  bool isOpen() const { return session_ != nullptr; }
  /// Registers the process: now if it is open, else as soon as it is. Rejects if the manager
  /// refuses now.
  kj::Promise<void> enrol(ProcessRecord process);
  /// Tells the manager what the process offers and needs now.
  void update(std::vector<ComponentRecord> components);
  /// Any thread. Returns what the manager does instead of knowing this process: "does not answer:
  /// connections live on ...", or "cannot be used: " and why; "" if it knows it.
  std::string trouble() const;

  /// The manager lets one question wait this long at most.
  static constexpr Duration kLongestWait = std::chrono::seconds(60);
  /// Resolves to where a process is, and waits for it at most `wait`, or kLongestWait if that is
  /// shorter. Rejects with what the manager knows, as DISCONNECTED if it is not open, or no longer.
  kj::Promise<ProcessRecord> resolve(const std::string& process, Duration wait);
  kj::Promise<std::vector<ProcessRecord>> list();

 private:
  kj::Promise<void> enrolNow();
  void stay(kj::Promise<void> enrolled);
  kj::Promise<void> keep();
  kj::Promise<void> renew();
  kj::Promise<void> comeBack(Duration pause);
  void drop();
  void setTrouble(const std::string& trouble);
  kj::Exception gone() const;

  loop::ControlThread& control_;
  const net::Address manager_;
  const std::string program_;
  const net::Trust trust_;
  const News news_;
  net::HostLookup lookup_;
  net::Address here_;
  kj::Maybe<kj::Own<framing::Link>> link_;
  kj::Maybe<wire::Session::Client> session_;
  kj::Maybe<wire::Lease::Client> lease_;
  ProcessRecord process_;
  bool untold_ = false;       // its components have changed since it was registered
  mutable std::mutex mutex_;  // guards the next one
  std::string trouble_;
  bool told_ = false;                          // there is trouble, and it is no secret
  kj::Promise<void> keeping_ = kj::READY_NOW;  // last: cancelled first
};

}  // namespace suture
