// These emit events of every prototype, in both directions at once.
#include "rt/scenarios/setup.h"

namespace scenarios {
namespace {

class Events : public Scenario {
 protected:
  /// Sends commands from `sender` whose execution the other end tells with an event, each twice.
  static void provoke(End& sender) {
    sender.with([](Used& used) {
      for (int i = 0; i < 2; ++i) {
        forEachPrototype(used, [](auto prototype) { EXPECT_TRUE(prototype.set(prototype.value)); });
      }
      EXPECT_TRUE(used.clear());
    });
  }
  static bool hasAll(const Received& received) {
    return received.scalars.size() == 2 && received.vectors.size() == 2 &&
           received.records.size() == 2 && received.texts.size() == 2 && received.cleared == 1;
  }
  static bool isRight(const Received& received) {
    return received.scalars[1] == 2.5 && received.vectors[1] == Vector(1, -2, 3) &&
           same(received.records[1], recordOf(4, "tip")) && received.texts[1] == "needle driver";
  }
};

TEST_P(Events, VoidAndWriteEventsReachBothEnds) {
  provoke(*client);
  provoke(*server);
  for (End* end : {client.get(), server.get()}) {
    ASSERT_TRUE(end->await(hasAll));
    EXPECT_TRUE(end->await(isRight));
  }
}

// An event of the other end makes this one send a command, and so on.
TEST_P(Events, ACommandFollowsAnEvent) {
  for (int i = 1; i <= 5; ++i) {
    client->with([&](Used& used) { EXPECT_TRUE(used.set_scalar(i)); });
    ASSERT_TRUE(client->await([&](const Received& received) {
      return received.scalars.size() == static_cast<std::size_t>(i) && received.scalars.back() == i;
    }));
  }
}

INSTANTIATE_TEST_SUITE_P(Matrix, Events, allCombinations(), nameOf);

}  // namespace
}  // namespace scenarios
