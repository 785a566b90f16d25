// The explorer shows what can come, and nothing that cannot.
#include <gtest/gtest.h>

#include "rt/model/litmus.h"

namespace model {
namespace {

std::string violationOf(Run (*scenario)()) {
  const std::string violation = explore(scenario).violation;
  return violation.substr(0, violation.find(';'));
}

TEST(Explorer, RunsEachOrderOnce) {
  EXPECT_EQ(explore(litmus::twoWritersOfOnePlace).runs, 6u);   // 4! / (2! 2!)
  EXPECT_EQ(explore(litmus::twoWritersOfTwoPlaces).runs, 1u);  // all alike
}

TEST(Explorer, FindsALostUpdate) {
  EXPECT_EQ(violationOf(litmus::lostUpdate), "an update is lost");
  EXPECT_EQ(violationOf(litmus::noLostUpdate), "");
}

TEST(Explorer, FindsAMessageThatIsNotReleased) {
  EXPECT_EQ(violationOf(litmus::messageNotReleased), "a race on plain memory: written unordered");
  EXPECT_EQ(violationOf(litmus::messageReleased), "");
}

TEST(Explorer, LetsALoadMissAStore) {
  EXPECT_EQ(violationOf(litmus::storeBuffering), "neither saw the other");
  EXPECT_EQ(violationOf(litmus::storeBufferingSequential), "");
  EXPECT_EQ(violationOf(litmus::readTwice), "");
}

}  // namespace
}  // namespace model
