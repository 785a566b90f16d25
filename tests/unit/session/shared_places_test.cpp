// What all peers ask for is bounded in all and of one peer.

#include <gtest/gtest.h>
#include <suture/session/provider/limits/shared_places.h>

#include <string>
#include <vector>

namespace suture {
namespace {

using net::PeerIdentity;

PeerIdentity certified(const std::string& process) {
  return {.proof = PeerIdentity::Proof::Certificate, .process = process};
}

class SharedPlacesTest : public testing::Test {
 protected:
  void take(std::size_t count, const PeerIdentity& who) {
    while (count-- > 0) taken_.push_back(places_.take(who));
  }
  std::string whyNone(const PeerIdentity& who) { return places_.whyNone(who).value_or("there is"); }

  SharedPlaces places_{{.all = 5, .ofOne = 2}};
  std::vector<Places::Place> taken_;
};

TEST_F(SharedPlacesTest, OnePeerLeavesRoomToOthers) {
  take(2, certified("greedy"));
  EXPECT_EQ(
      whyNone(certified("greedy")),
      "2 of them are with process 'greedy', and no peer has more. End some of its processes.");
  EXPECT_EQ(whyNone(certified("other")), "there is");
  take(2, certified("other"));
  take(1, certified("third"));
  EXPECT_EQ(whyNone(certified("third")),
            "it has 5 of them, and no process has more. End some of its peers.");
}

TEST_F(SharedPlacesTest, ThoseGivenBackAreFreeAgain) {
  take(2, certified("greedy"));
  taken_.clear();
  EXPECT_EQ(whyNone(certified("greedy")), "there is");
  take(2, certified("greedy"));
  EXPECT_NE(whyNone(certified("greedy")), "there is");
}

TEST_F(SharedPlacesTest, PeersWithoutProofShareAll) {
  take(4, {});
  EXPECT_EQ(whyNone({}), "there is");
  take(1, {});
  EXPECT_EQ(whyNone({}), "it has 5 of them, and no process has more. End some of its peers.");
}

}  // namespace
}  // namespace suture
