// The other process writes into a slot while this one stores a value there.
#include <gtest/gtest.h>
#include <suture/base/memory_block.h>
#include <suture/base/slots/slots.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdint>
#include <map>
#include <new>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace suture {
namespace {

constexpr std::uint32_t kElements = 64;

/// A Rewriter is another process, which writes one word after another of some memory, without end.
class Rewriter {
 public:
  Rewriter(std::byte* memory, std::size_t words) : pid_(fork()) {
    if (pid_ != 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // also if the test crashes
    auto* const first = reinterpret_cast<std::uint32_t*>(memory);
    for (std::uint32_t value = 0;; value = value * 1664525 + 1013904223) {
      for (std::size_t i = 0; i < words; ++i) {
        std::atomic_ref(first[i]).store(value, std::memory_order_relaxed);
        std::atomic_ref(first[i]).store(~0u, std::memory_order_relaxed);
      }
    }
  }
  ~Rewriter() {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Rewriter(const Rewriter&) = delete;
  Rewriter& operator=(const Rewriter&) = delete;

 private:
  const pid_t pid_;
};

/// Holds a slot in memory that another process has mapped.
template <class Slot>
class SlotInSharedMemory : public testing::Test {
 protected:
  static constexpr int kTimes = 1000;

  /// Stores the value while the other process writes `words` words of the slot, until it has been
  /// seen so many times that the other one has written the size since.
  template <class Value>
  void storeBeside(const Value& value, std::size_t words) {
    store(value, *slot_);
    const std::uint32_t size = slot_->size;
    const Rewriter rewriter(block_.data(), words);
    for (int seen = 0; seen < kTimes;) {
      store(value, *slot_);
      if (std::atomic_ref(slot_->size).load() != size) ++seen;
    }
  }

 private:
  MemoryBlock block_{"hostile slot", sizeof(Slot)};
  Slot* const slot_ = new (block_.data()) Slot;
};

constexpr std::size_t kOnlyItsSize = 1;
template <class Slot>
constexpr std::size_t kAllOfIt = sizeof(Slot) / sizeof(std::uint32_t);

using Names = BoundedList<BoundedText<12>, kElements>;
using NamedNumbers = BoundedList<SlotEntry<BoundedText<12>, double>, kElements>;
using Numbers = BoundedList<double, kElements>;
using Points = BoundedList<std::array<double, 3>, kElements>;

std::string nameOf(int i) { return "joint" + std::to_string(i); }

using HostileNames = SlotInSharedMemory<Names>;
TEST_F(HostileNames, StoreReadsNothingBehindAVector) {
  storeBeside(std::vector<std::string>{nameOf(1), nameOf(2)}, kOnlyItsSize);
}
TEST_F(HostileNames, StoreSortsOnlyElementsOfASet) {
  storeBeside(std::set<std::string>{nameOf(1), nameOf(2)}, kOnlyItsSize);
}
TEST_F(HostileNames, StoreSortsWhileElementsChange) {
  std::unordered_set<std::string> names;
  for (int i = 0; i < 60; ++i) names.insert(nameOf(i));
  storeBeside(names, kAllOfIt<Names>);
}

using HostileMap = SlotInSharedMemory<NamedNumbers>;
TEST_F(HostileMap, StoreSortsOnlyEntriesOfAMap) {
  storeBeside(std::map<std::string, double>{{nameOf(1), 1}, {nameOf(2), 2}}, kOnlyItsSize);
}
TEST_F(HostileMap, StoreSortsWhileKeysChange) {
  std::unordered_map<std::string, double> numbers;
  for (int i = 0; i < 60; ++i) numbers[nameOf(i)] = i;
  storeBeside(numbers, kAllOfIt<NamedNumbers>);
}

using HostileNumbers = SlotInSharedMemory<Numbers>;
TEST_F(HostileNumbers, StoreCopiesNothingBehindAVector) {
  storeBeside(std::vector<double>{1, 2}, kOnlyItsSize);
}
TEST_F(HostileNumbers, StoreCopiesNothingBehindAnEigenVector) {
  storeBeside(Eigen::VectorXd(Eigen::VectorXd::Ones(2)), kOnlyItsSize);
}

using HostilePoints = SlotInSharedMemory<Points>;
TEST_F(HostilePoints, StoreCopiesNothingBehindAMatrix) {
  storeBeside(Eigen::Matrix3Xd(Eigen::Matrix3Xd::Ones(3, 2)), kOnlyItsSize);
}

}  // namespace
}  // namespace suture
