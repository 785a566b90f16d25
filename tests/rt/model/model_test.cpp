// These run the parts between threads in every order of their accesses.
#include <gtest/gtest.h>

#include <iostream>

#include "rt/model/scenarios.h"

namespace model {
namespace {

struct Part {
  const char* name;
  Run (*scenario)();
};

void PrintTo(const Part& part, std::ostream* out) { *out << part.name; }

class Model : public testing::TestWithParam<Part> {};

TEST_P(Model, HoldsInEveryOrder) {
  const Outcome outcome = explore(GetParam().scenario);
  std::cout << outcome.runs << " orders, " << outcome.given_up << " begun that are like others\n";
  EXPECT_EQ(outcome.violation, "");
  EXPECT_GT(outcome.runs + outcome.given_up, 50u) << "the threads hardly met";
}

INSTANTIATE_TEST_SUITE_P(
    Parts, Model,
    testing::Values(
        Part{"SpscRing", spscRing}, Part{"MpscRing", mpscRing}, Part{"LatestCell", latestCell},
        Part{"MailboxOrder", mailboxOrder}, Part{"MailboxCredits", mailboxCredits},
        Part{"MailboxRoom", mailboxRoom}, Part{"StateRow", stateRow},
        Part{"StateOrder", stateOrder}, Part{"Snapshot", snapshot}, Part{"EventQueue", eventQueue},
        Part{"EventQueueOfTwo", eventQueueOfTwo}, Part{"EventQueueLarge", eventQueueLarge},
        Part{"EventQueueLargeOfOne", eventQueueLargeOfOne},
        Part{"EventQueueOfOne", eventQueueOfOne}, Part{"EventQueueLatched", eventQueueLatched},
        Part{"Doorbell", doorbell}, Part{"DoorbellForTwo", doorbellForTwo}),
    [](const auto& part) { return std::string(part.param.name); });

}  // namespace
}  // namespace model
