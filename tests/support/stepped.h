#pragma once
// The tests of this project make their clocks with these options.

#include <gtest/gtest.h>
#include <suture/testing/test_clock.h>

#include <cstdlib>
#include <string>
#include <string_view>

namespace suture {

/// Returns the options of every test's clock. A problem fails the test. Threads run together if the
/// environment says SUTURE_TEST_THREADS=together, as ThreadSanitizer needs them. SUTURE_TEST_SEED
/// chooses another order of threads that are due at one moment; the tests must pass with each.
inline TestClockOptions steppedOptions() {
  const char* const threads = std::getenv("SUTURE_TEST_THREADS");
  const bool together = threads != nullptr && threads == std::string_view("together");
  const char* const seed = std::getenv("SUTURE_TEST_SEED");
  return {.threads = together ? Threads::Together : Threads::OneAtATime,
          .seed = seed == nullptr ? 0 : std::strtoull(seed, nullptr, 10),
          .problem = [](const std::string& problem) { ADD_FAILURE() << problem; }};
}

/// Returns the clock of the test that runs, in a program with stepped_main.cpp.
TestClock& clockOfTest();

}  // namespace suture
