#include "cli/peer/link.h"
#include <suture/net/dialer.h>
#include <suture/net/host_lookup.h>
#include "cli/peer/wait.h"

namespace suture::cli {
namespace {

std::string noAnswer(const rpc::Address& address) {
  return "connect to " + address.text() + ": no answer. Look at what runs there.";
}

}  // namespace

void knock(rpc::EventPort& loop, const rpc::Address& address, Duration limit) {
  wait(loop, limit + std::chrono::seconds(1), rpc::dial(loop, address, limit), noAnswer(address));
}

Reached reach(rpc::EventPort& loop, const rpc::Address& address, const rpc::Trust& trust,
              const std::string& expected, Duration limit) {
  rpc::requireKeys(address, trust);
  rpc::HostLookup lookup(loop, address);
  auto reached = lookup.places(limit).then([&](std::vector<rpc::Address> places) {
    return rpc::reachFirst(loop, std::move(places), trust, expected, limit);
  });
  auto bytes = wait(loop, 4 * limit + std::chrono::seconds(1), kj::mv(reached), noAnswer(address));
  std::string end = bytes.certificatesEnd();
  auto stream = kj::heap<rpc::MessageStream>(loop, kj::mv(bytes));
  return {kj::heap<rpc::Link>(kj::mv(stream), capnp::rpc::twoparty::Side::CLIENT), std::move(end)};
}

}  // namespace suture::cli
