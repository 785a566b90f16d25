// These wait for every kind of command with every prototype.
#include <chrono>

#include "rt/scenarios/setup.h"
#include "support/patience.h"

namespace scenarios {
namespace {

using namespace std::chrono_literals;

class Blocking : public Scenario {};

TEST_P(Blocking, VoidAndWriteRunBeforeTheirAnswer) {
  client->with([](Used& used) {
    forEachPrototype(used, [](auto prototype) {
      ASSERT_TRUE(prototype.set.start(prototype.value).within(suture::kPatience));
      const auto kept = prototype.read.fresh().within(suture::kPatience);
      ASSERT_TRUE(kept);
      EXPECT_TRUE(same(*kept, prototype.value));
    });
    ASSERT_TRUE(used.clear.start().within(suture::kPatience));
    const auto text = used.text.fresh().within(suture::kPatience);
    ASSERT_TRUE(text);
    EXPECT_EQ(*text, "");
  });
}

TEST_P(Blocking, AQualifiedReadAnswersItsQuestion) {
  client->with([](Used& used) {
    forEachPrototype(used, [](auto prototype) {
      const auto twice = prototype.twice.start(prototype.value).within(suture::kPatience);
      ASSERT_TRUE(twice);
      EXPECT_TRUE(same(*twice, doubled(prototype.value)));
    });
  });
}

TEST_P(Blocking, CommandsWithReturnAnswerWhatWasKept) {
  client->with([](Used& used) {
    forEachPrototype(used, [](auto prototype) {
      const auto before = prototype.swap.start(prototype.value).within(suture::kPatience);
      ASSERT_TRUE(before);
      EXPECT_FALSE(same(*before, prototype.value));
      const auto taken = prototype.take.start().within(suture::kPatience);
      ASSERT_TRUE(taken);
      EXPECT_TRUE(same(*taken, prototype.value));
      const auto nothing = prototype.take.start().within(suture::kPatience);
      ASSERT_TRUE(nothing);
      EXPECT_TRUE(same(*nothing, *before));
    });
  });
}

INSTANTIATE_TEST_SUITE_P(Matrix, Blocking, allCombinations(), nameOf);

}  // namespace
}  // namespace scenarios
