#pragma once
// This says how a process proves who it is, and what it lets its peers do.

#include <suture/names/policy.h>
#include <suture/net/trust.h>

#include <memory>

namespace suture {

/// A Security is a plain value of set-up code; the keys may be shared by threads. It has no keys,
/// so no tls:// addresses, and the policy of Policy(), unless they are set.
struct Security {
  std::shared_ptr<const tls::Keys> keys{};
  Policy policy{};

  /// Returns which peers this process trusts, by its keys and its policy.
  net::Trust trust() const { return {.keys = keys, .users = policy.users()}; }
};

}  // namespace suture
