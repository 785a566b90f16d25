#pragma once
// This finds hosts by their names.

#include <suture/base/time.h>
#include <suture/loop/event_port.h>
#include <suture/loop/kj_comparisons.h>
#include <suture/net/address.h>

#include <memory>
#include <vector>

namespace suture::net {

/// Returns the address with a number in place of its host's name. If it has a number already,
/// returns it as it is; else returns what the system's name service says, the best first, and
/// blocks until it answers. Throws SetupError.
std::vector<Address> lookUp(const Address& address);

/// Belongs to the thread of `port`. Does what lookUp() does for threads that must not block: it
/// asks in a thread of its own, at most one for each object, which ends when the name service
/// answers.
class HostLookup {
 public:
  HostLookup(loop::EventPort& port, const Address& address);

  /// Returns where the host is now, or where it was last if the name service does not say. If it
  /// never did, rejects as DISCONNECTED, with what was found and what to do. Takes no longer than
  /// `limit`.
  kj::Promise<std::vector<Address>> places(Duration limit);

 private:
  struct Question;

  kj::Promise<void> ask();
  kj::Promise<std::vector<Address>> known(const std::string& why) const;

  loop::EventPort& port_;
  const Address address_;
  std::vector<Address> known_;
  std::string why_;  // why the latest question had no answer
  bool asking_ = false;
  kj::ForkedPromise<void> answer_ = kj::Promise<void>(kj::READY_NOW).fork();
};

}  // namespace suture::net
