// The main() of test programs whose time is stepped: each test has a clock of its own, from before
// its fixture is made until after that is gone.
#include <gtest/gtest.h>
#include <suture/testing/test_clock.h>

#include <cstdlib>
#include <optional>
#include <string_view>

namespace {

/// As ThreadSanitizer needs them if the environment says SUTURE_TEST_THREADS=together.
suture::Threads threads() {
  const char* const asked = std::getenv("SUTURE_TEST_THREADS");
  const bool together = asked != nullptr && asked == std::string_view("together");
  return together ? suture::Threads::Together : suture::Threads::OneAtATime;
}

class Clocks final : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo&) override {
    clock_.emplace(suture::TestClockOptions{
        .threads = threads(),
        .problem = [](const std::string& problem) { ADD_FAILURE() << problem; }});
  }
  void OnTestEnd(const testing::TestInfo&) override { clock_.reset(); }

  std::optional<suture::TestClock> clock_;
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  testing::UnitTest::GetInstance()->listeners().Append(new Clocks);
  return RUN_ALL_TESTS();
}
