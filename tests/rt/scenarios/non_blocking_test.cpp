// These send every kind of command with every prototype, without waiting, and see its effect later.
#include <optional>
#include <utility>

#include "rt/scenarios/setup.h"
#include "support/eventually.h"

namespace scenarios {
namespace {

using suture::eventually;

class NonBlocking : public Scenario {
 protected:
  /// Does `step` in the client's thread again and again, in cycles of its own, until it is true.
  template <class Step>
  bool repeatedly(const Step& step) {
    return eventually([&] {
      bool done = false;
      client->with([&](Used& used) { done = step(used); });
      return done;
    });
  }
};

TEST_P(NonBlocking, AWrittenValueIsReadLater) {
  client->with([](Used& used) {
    forEachPrototype(used, [](auto prototype) { EXPECT_TRUE(prototype.set(prototype.value)); });
  });
  EXPECT_TRUE(repeatedly([](Used& used) {
    bool all = true;
    forEachPrototype(used, [&](auto prototype) {
      const auto kept = prototype.read();
      all = all && kept && same(*kept, prototype.value);
    });
    return all;
  }));
  client->with([](Used& used) { EXPECT_TRUE(used.clear()); });
  EXPECT_TRUE(repeatedly([](Used& used) {
    const auto text = used.text();
    return text && text->empty();
  }));
}

// An answer is started in one cycle, and looked at in later ones.
TEST_P(NonBlocking, AnAnswerIsPolledFor) {
  using Question = decltype(std::declval<Used&>().twice_text.start(""));
  using Exchange = decltype(std::declval<Used&>().swap_scalar.start(0.0));
  std::optional<Question> question;
  std::optional<Exchange> exchange;
  client->with([&](Used& used) {
    question.emplace(used.twice_text.start("ab"));
    exchange.emplace(used.swap_scalar.start(7));
  });
  EXPECT_TRUE(repeatedly([&](Used&) { return question->poll() && exchange->poll(); }));
  client->with([&](Used&) {
    ASSERT_TRUE(*question->poll());
    EXPECT_EQ(**question->poll(), "abab");
    ASSERT_TRUE(*exchange->poll());
    EXPECT_EQ(**exchange->poll(), 0);
    question.reset();
    exchange.reset();
  });
}

INSTANTIATE_TEST_SUITE_P(Matrix, NonBlocking, allCombinations(), nameOf);

}  // namespace
}  // namespace scenarios
