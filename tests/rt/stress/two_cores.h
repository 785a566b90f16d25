#pragma once
// How long the stress lasts and where its threads run.

#include <functional>
#include <string>
#include <vector>

namespace stress {

/// Runs until a time is over: a tenth of a second, or as many seconds as SUTURE_STRESS_SECONDS
/// says.
class Span {
 public:
  Span();
  bool over() const;

 private:
  long long end_;
};

/// Runs each of `bodies` in a thread of its own, pinned to one processor after the other of those
/// that the process may use, and returns when all have.
void runAcrossProcessors(const std::vector<std::function<void()>>& bodies);

/// Counts what must not be, of one consumer.
struct Faults {
  unsigned long long torn = 0, backwards = 0, seen = 0;

  /// Of what has been received: its serial number must be greater than any before. Returns it.
  unsigned long long take(unsigned long long serial);
  /// No use to go on: what is broken may never come to an end.
  bool hopeless() const { return torn + backwards > 100; }

 private:
  unsigned long long last_ = 0;
};

/// Reports `faults` of `what` to gtest, and that anything was seen at all.
void expectNone(const Faults& faults, const std::string& what);

}  // namespace stress
