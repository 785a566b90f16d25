#include "cli/peer/link.h"
#include <suture/net/dialer.h>
#include <suture/net/host_lookup.h>
#include "cli/peer/wait.h"

namespace suture::cli {
namespace {

std::string noAnswer(const net::Address& address) {
  return "connect to " + address.text() + ": no answer. Look at what runs there.";
}

}  // namespace

void knock(loop::EventPort& loop, const net::Address& address, Duration limit) {
  wait(loop, limit + std::chrono::seconds(1), net::dial(loop, address, limit), noAnswer(address));
}

Reached reach(loop::EventPort& loop, const net::Address& address, const net::Trust& trust,
              const std::string& expected, Duration limit) {
  net::requireKeys(address, trust);
  net::HostLookup lookup(loop, address);
  auto reached = lookup.places(limit).then([&](std::vector<net::Address> places) {
    return net::reachFirst(loop, std::move(places), trust, expected, limit);
  });
  auto bytes = wait(loop, 4 * limit + std::chrono::seconds(1), kj::mv(reached), noAnswer(address));
  std::string end = bytes.certificatesEnd();
  auto stream = kj::heap<framing::MessageStream>(loop, kj::mv(bytes));
  return {kj::heap<framing::Link>(kj::mv(stream), capnp::rpc::twoparty::Side::CLIENT),
          std::move(end)};
}

}  // namespace suture::cli
