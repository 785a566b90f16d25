// Each end of a second connection says in time why the other neither sends nor takes its first
// bytes.

#include <gtest/gtest.h>
#include <suture/framing/preamble.h>

#include <string>

#include "stream_and_peer.h"
#include "support/contains.h"
#include "support/refusal.h"

namespace suture::framing {
namespace {

TEST(Preamble, APeerThatIsGoneTakesNothing) {
  loop::EventPort port;
  auto pair = makeSocketPair();
  pair.theirs = nullptr;
  const std::string error = refusal(
      [&] { exchangeToken(port, net::ByteStream(kj::mv(pair.ours)), Token{}).wait(port.scope()); });
  EXPECT_TRUE(contains(error, "the second connection takes nothing")) << error;
}

TEST(Preamble, ASilentPeerIsReported) {
  loop::EventPort port;
  auto pair = makeSocketPair();
  const std::string error = refusal([&] {
    readPreamble(port, net::ByteStream(kj::mv(pair.ours)), {.firstMilliseconds = 20})
        .wait(port.scope());
  });
  EXPECT_TRUE(contains(error, kSilent)) << error;
}

}  // namespace
}  // namespace suture::framing
