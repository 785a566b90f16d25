#pragma once
// Hosts that are known by name.

#include <suture/base/time.h>
#include <suture/loop/event_port.h>
#include <suture/loop/kj_comparisons.h>
#include <suture/net/address.h>

#include <memory>
#include <vector>

namespace suture::rpc {

/// The address with a number for its host: itself if it has one, else what the system's name
/// service says, the best first. Blocks for as long as that takes. Throws SetupError.
std::vector<Address> lookUp(const Address& address);

/// Belongs to the thread of `port`. The same for those who must not block: asks in a thread of its
/// own, at most one for each object, which ends when the name service answers.
class HostLookup {
 public:
  HostLookup(EventPort& port, const Address& address);

  /// Where the host is now, or where it was last if the name service does not say. Rejects, as
  /// DISCONNECTED, if it never did, with what was found and what to do; at the latest after
  /// `limit`.
  kj::Promise<std::vector<Address>> places(Duration limit);

 private:
  struct Question;

  kj::Promise<void> ask();
  kj::Promise<std::vector<Address>> known(const std::string& why) const;

  EventPort& port_;
  const Address address_;
  std::vector<Address> known_;
  std::string why_;  // of the latest answer, if it was none
  bool asking_ = false;
  kj::ForkedPromise<void> answer_ = kj::Promise<void>(kj::READY_NOW).fork();
};

}  // namespace suture::rpc
