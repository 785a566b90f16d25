#pragma once
// This is what the C++ memory model lets each thread of a run see.

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace model {

constexpr std::size_t kMaxThreads = 4;

/// Keeps for each place the stores in the order in which they came, and for each thread what has
/// happened before its present. A load may return any store but those that a later one is known to
/// have replaced: by happens-before, or since the thread has seen it.
///
/// It is stronger than the standard in three ways: a store comes last in its place's order when it
/// is made; nothing is read before it is stored; seq_cst loads and failed exchanges see the newest.
class Memory {
 public:
  void begin(std::size_t threads);

  /// Returns how many different stores a load may return. `initial` is what the place held before
  /// the run.
  std::size_t choices(std::size_t thread, const void* place, std::uint64_t initial);
  /// Loads the store that is `age` places from the newest.
  std::uint64_t load(std::size_t thread, const void* place, std::size_t age, bool acquires);
  void store(std::size_t thread, const void* place, std::uint64_t initial, std::uint64_t value,
             bool releases, bool readModifyWrite);

  /// An access to a word of plain memory: nullptr, or why it is a race.
  const char* plain(std::size_t thread, const void* word, bool writes);

 private:
  using Clock = std::array<std::uint32_t, kMaxThreads>;
  struct Store {
    std::uint64_t value = 0;
    std::size_t writer = 0;
    std::uint32_t time = 0;  // the writer's, when it stored this
    Clock carries{};         // what an acquiring load of it then knows
  };
  struct Sight {
    std::uint32_t time;  // the reader's, when it saw this
    std::size_t store;
  };
  struct Place {
    std::vector<Store> stores;
    std::array<std::vector<Sight>, kMaxThreads> seen;
    std::array<unsigned, kMaxThreads> stale{};  // loads in a row that did not see the newest
  };
  struct Shadow {  // what is known of a word of plain memory
    std::size_t writer = 0;
    std::uint32_t written = 0;
    Clock read{};
  };

  static void join(Clock& clock, const Clock& other);
  Place& at(const void* place, std::uint64_t initial);
  std::size_t oldestVisible(std::size_t thread, const Place& place) const;

  std::size_t threads_ = 0;
  std::array<Clock, kMaxThreads> clocks_{};
  std::map<const void*, Place> places_;
  std::map<const void*, Shadow> shadows_;
};

}  // namespace model
