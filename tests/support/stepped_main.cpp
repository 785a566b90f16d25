// The main() of test programs whose time is stepped: each test has a clock of its own, from before
// its fixture is made until after that is gone.
#include <gtest/gtest.h>

#include <optional>

#include "support/stepped.h"

namespace {

std::optional<suture::TestClock> stepped;

class Clocks final : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo&) override { stepped.emplace(suture::steppedOptions()); }
  void OnTestEnd(const testing::TestInfo&) override { stepped.reset(); }
};

}  // namespace

suture::TestClock& suture::clockOfTest() { return *stepped; }

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  testing::UnitTest::GetInstance()->listeners().Append(new Clocks);
  return RUN_ALL_TESTS();
}
