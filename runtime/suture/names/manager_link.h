#pragma once
// This connects a process to what knows names: the global manager, or each of several.

#include <suture/names/manager_lease.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace suture {

/// Belongs to the control thread; outlives its promises. Registers a process at every global
/// manager that is listed, and asks all of them, so that it does not matter which of them live, and
/// nothing has to be handed over when one dies.
class ManagerLink {
 public:
  /// `managers` has at least one, in the order in which they are asked for names. `news` hears of
  /// each in the control thread.
  ManagerLink(
      loop::ControlThread& control, const std::vector<net::Address>& managers,
      const std::string& program, const net::Trust& trust = {},
      const ManagerLease::News& news = [](const net::Address&, const std::string&) {});

  /// Resolves as soon as one manager answers and the others have answered or failed; tries again
  /// for `patience`. Rejects with what was found and what to do.
  kj::Promise<void> open(Duration patience);
  /// Registers this process at each manager that answers, and at the others when they do. Rejects
  /// if one says that the name is taken.
  kj::Promise<void> enrol(const ProcessRecord& process);
  /// Tells the managers what the process offers and needs now.
  void update(const std::vector<ComponentRecord>& components);

  /// Resolves to where a process is, as the first manager says that knows it. Waits for the
  /// process, and for a manager that answers, at most `wait`. Rejects with what the managers know.
  kj::Promise<ProcessRecord> resolve(const std::string& process, Duration wait);
  /// Resolves to what the first manager knows that answers.
  kj::Promise<std::vector<ProcessRecord>> list();

  /// Returns the address of the first manager that answers.
  const net::Address& address() const { return nearest().address(); }
  /// Once open: returns where peers of the network of that manager reach this machine, with port 0.
  const net::Address& here() const { return nearest().here(); }
  /// Resolves to a stream to a process that the managers know, at its addressOf(). net::reach()
  /// says what `limit` holds for.
  kj::Promise<net::ByteStream> reach(const ProcessRecord& process, Duration limit);
  /// Any thread. Returns the addresses of the managers that do not know this process.
  std::string missing() const;
  /// Any thread. Returns trouble() of each of them, by its address.
  std::map<std::string, std::string> troubles() const;

 private:
  using Leases = std::vector<std::unique_ptr<ManagerLease>>;
  struct Failures;

  ManagerLease& nearest() const;
  kj::Promise<void> enrolFrom(Leases::const_iterator first, const ProcessRecord& process);
  kj::Promise<ProcessRecord> askAll(const std::string& process, Duration wait);
  kj::Exception notOpen(const Failures& failures) const;
  kj::Exception gone(const std::string& asked) const;

  loop::ControlThread& control_;
  const net::Trust trust_;
  Leases leases_;
};

}  // namespace suture
