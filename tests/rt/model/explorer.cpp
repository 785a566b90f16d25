#include "rt/model/explorer.h"

#include <ucontext.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

#include "rt/model/memory.h"

namespace model {
namespace {

constexpr std::size_t kStackBytes = std::size_t{256} * 1024;

using Threads = std::uint32_t;  // a bit each

struct Access {
  const void* place = nullptr;
  bool writes = false;
};

bool independent(const Access& a, const Access& b) {
  return a.place != b.place || (!a.writes && !b.writes);
}

/// A Choice is a moment of a run at which one of several threads had to be chosen.
struct Choice {
  Threads enabled = 0;
  Threads asleep = 0;  // another run has seen what comes if one of them is next
  Threads tried = 0;
  std::size_t chosen = 0;
  std::size_t value = 0, values = 1;  // which of so many values its load returns
  std::array<Access, kMaxThreads> next{};
};

class Exploration {
 public:
  Outcome explore(const std::function<Run()>& scenario);

  void access(const void* place, bool writes);
  std::uint64_t load(const void* place, std::uint64_t newest, bool acquires, bool newestOnly);
  void store(const void* place, std::uint64_t old, std::uint64_t value, bool releases,
             bool readModifyWrite);
  void plain(const void* word, bool writes);
  void violate(const char* what);
  /// Returns true if several threads of the run can see `memory`.
  bool shared(const std::byte* memory) const;

 private:
  struct Fiber {
    ucontext_t context{};
    std::unique_ptr<char[]> stack{new char[kStackBytes]};
    bool ended = false;
    Access next;
  };

  void run(const Run& run);
  void start(const Run& run);
  void resume(std::size_t thread);
  bool choose();
  Threads asleepAfter(const Choice& choice) const;
  Choice present() const;
  bool backtrack();
  static void body(unsigned thread);

  std::array<Fiber, kMaxThreads> fibers_;
  std::size_t count_ = 0;
  ucontext_t scheduler_{};
  const Run* run_ = nullptr;
  int current_ = -1;  // -1: no thread of the run
  std::vector<Choice> choices_;
  std::size_t depth_ = 0;
  Memory memory_;
  Outcome outcome_;
};

// There is one exploration at a time: the atomics of the code under test report to it.
Exploration* exploration = nullptr;

Outcome Exploration::explore(const std::function<Run()>& scenario) {
  exploration = this;
  do {
    run(scenario());
  } while (outcome_.violation.empty() && backtrack());
  exploration = nullptr;
  return outcome_;
}

void Exploration::run(const Run& one) {
  start(one);
  for (depth_ = 0; present().enabled != 0; ++depth_) {
    if (!choose()) {
      ++outcome_.given_up;
      return;
    }
    resume(choices_[depth_].chosen);
    if (!outcome_.violation.empty()) return;
  }
  ++outcome_.runs;
  one.atEnd();
}

// Runs each thread up to its first access: what comes before concerns no other thread.
void Exploration::start(const Run& one) {
  run_ = &one;
  count_ = one.threads.size();
  memory_.begin(count_);
  for (std::size_t i = 0; i < count_; ++i) {
    Fiber& fiber = fibers_[i];
    fiber.ended = false;
    getcontext(&fiber.context);
    fiber.context.uc_stack.ss_sp = fiber.stack.get();
    fiber.context.uc_stack.ss_size = kStackBytes;
    fiber.context.uc_link = &scheduler_;
    makecontext(&fiber.context, reinterpret_cast<void (*)()>(&Exploration::body), 1,
                static_cast<unsigned>(i));
    resume(i);
  }
}

void Exploration::body(unsigned thread) {
  exploration->run_->threads[thread]();
  exploration->fibers_[thread].ended = true;
}

void Exploration::resume(std::size_t thread) {
  current_ = static_cast<int>(thread);
  swapcontext(&scheduler_, &fibers_[thread].context);
  current_ = -1;
}

Choice Exploration::present() const {
  Choice choice;
  for (std::size_t i = 0; i < count_; ++i) {
    if (!fibers_[i].ended) choice.enabled |= 1u << i;
    choice.next[i] = fibers_[i].next;
  }
  return choice;
}

// A thread that slept, or was tried in the place of the chosen one, stays asleep until something
// happens that matters to it.
Threads Exploration::asleepAfter(const Choice& choice) const {
  Threads asleep = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const bool known = ((choice.asleep | choice.tried) >> i & 1) != 0 && i != choice.chosen;
    if (known && independent(choice.next[i], choice.next[choice.chosen])) asleep |= 1u << i;
  }
  return asleep;
}

/// Decides which thread is next, unless it has been decided. Returns false if every choice has been
/// seen elsewhere.
bool Exploration::choose() {
  Choice choice = present();
  if (depth_ < choices_.size()) {
    choices_[depth_].next = choice.next;  // the same accesses, of this run's objects
    return true;
  }
  if (depth_ > 0) choice.asleep = asleepAfter(choices_[depth_ - 1]);
  const Threads open = choice.enabled & ~choice.asleep;
  if (open == 0) return false;
  choice.chosen = static_cast<std::size_t>(__builtin_ctz(open));
  choices_.push_back(choice);
  return true;
}

/// Goes back to the last choice that has another way; returns false if there is none.
bool Exploration::backtrack() {
  while (!choices_.empty()) {
    Choice& last = choices_.back();
    if (++last.value < last.values) return true;
    last.value = 0;
    last.values = 1;
    last.tried |= 1u << last.chosen;
    const Threads open = last.enabled & ~last.asleep & ~last.tried;
    if (open != 0) {
      last.chosen = static_cast<std::size_t>(__builtin_ctz(open));
      return true;
    }
    choices_.pop_back();
  }
  return false;
}

void Exploration::access(const void* place, bool writes) {
  if (current_ < 0) return;
  Fiber& fiber = fibers_[static_cast<std::size_t>(current_)];
  fiber.next = {place, writes};
  swapcontext(&fiber.context, &scheduler_);
}

std::uint64_t Exploration::load(const void* place, std::uint64_t newest, bool acquires,
                                bool newestOnly) {
  if (current_ < 0) return newest;
  const auto thread = static_cast<std::size_t>(current_);
  Choice& choice = choices_[depth_];
  const std::size_t values = memory_.choices(thread, place, newest);
  choice.values = newestOnly ? 1 : values;
  return memory_.load(thread, place, choice.value, acquires);
}

void Exploration::store(const void* place, std::uint64_t old, std::uint64_t value, bool releases,
                        bool readModifyWrite) {
  if (current_ < 0) return;
  memory_.store(static_cast<std::size_t>(current_), place, old, value, releases, readModifyWrite);
}

void Exploration::plain(const void* word, bool writes) {
  access(word, writes);
  if (current_ < 0) return;
  const char* race = memory_.plain(static_cast<std::size_t>(current_), word, writes);
  if (race != nullptr) violate(race);
}

bool Exploration::shared(const std::byte* memory) const {
  if (current_ < 0) return false;
  const char* stack = fibers_[static_cast<std::size_t>(current_)].stack.get();
  const auto* place = reinterpret_cast<const char*>(memory);
  return place < stack || place >= stack + kStackBytes;
}

void Exploration::violate(const char* what) {
  if (!outcome_.violation.empty()) return;
  outcome_.violation = std::string(what) + "; threads in the order";
  for (const Choice& choice : choices_) outcome_.violation += " " + std::to_string(choice.chosen);
}

}  // namespace

Outcome explore(const std::function<Run()>& scenario) { return Exploration().explore(scenario); }

void require(bool holds, const char* what) {
  if (!holds) exploration->violate(what);
}

void write(std::byte* word, std::uint64_t value) {
  exploration->plain(word, true);
  std::memcpy(word, &value, sizeof(value));
}

std::uint64_t read(const std::byte* word) {
  exploration->plain(word, false);
  std::uint64_t value;
  std::memcpy(&value, word, sizeof(value));
  return value;
}

void copy(std::byte* to, const std::byte* from, std::size_t size) {
  constexpr std::size_t kWord = sizeof(std::uint64_t);
  const bool shared = exploration != nullptr && exploration->shared(to);
  for (std::size_t i = 0; i < size; i += kWord) {
    if (shared) exploration->plain(to + i, true);
    std::memcpy(to + i, from + i, std::min(kWord, size - i));
  }
}

void access(const void* place, bool writes) {
  if (exploration != nullptr) exploration->access(place, writes);
}

std::uint64_t load(const void* place, std::uint64_t newest, bool acquires, bool newestOnly) {
  return exploration == nullptr ? newest : exploration->load(place, newest, acquires, newestOnly);
}

void store(const void* place, std::uint64_t old, std::uint64_t value, bool releases,
           bool readModifyWrite) {
  if (exploration != nullptr) exploration->store(place, old, value, releases, readModifyWrite);
}

}  // namespace model
