#pragma once
// A required interface has one connection, the latest: these say which that is.

#include <suture/lane/provider_end.h>

#include <cstdint>
#include <map>
#include <string>

namespace suture {

/// Belongs to the control thread. Names of clients are given here with who has proved to be behind
/// them, since any peer may give them.
class LatestConnections {
 public:
  /// Describes the latest connection of a required interface of a peer.
  struct Latest {
    std::string bootId;  // the peer's machine, whose clock gave the epoch
    std::int64_t epoch;
    std::uint64_t incarnation;  // the peer's; 0: it does not say
    std::uint64_t greeting;     // by which the session began: nextGreeting() numbers them
    ProviderEnd* end;
  };

  std::uint64_t nextGreeting() { return ++greetings_; }
  /// Returns why the connection `name`, which has no end yet, may not take the place of the latest
  /// one of `client`; "" if it may.
  std::string whySuperseded(const std::string& client, const std::string& name,
                            const Latest& asked) const;
  /// Ends the latest connection, ahead of a later one.
  void end(const std::string& client);
  void set(const std::string& client, const Latest& latest) { latest_[client] = latest; }
  void forget(const ProviderEnd& end);

 private:
  std::map<std::string, Latest> latest_;  // by required interface, with its process
  std::uint64_t greetings_ = 0;
};

}  // namespace suture
