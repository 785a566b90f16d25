#include "bench/network/bare_memory.h"

#include <linux/futex.h>
#include <suture/base/errors.h>
#include <suture/base/memory_block.h>
#include <suture/base/time.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstring>
#include <new>
#include <vector>

#include "bench/placement.h"

namespace bench {
namespace {

using suture::now;
using Bytes = std::vector<std::byte>;

/// A Way is one direction: a number that counts the values, and behind it the last one.
struct alignas(64) Way {
  std::atomic<std::uint32_t> count{0};

  std::byte* value() { return reinterpret_cast<std::byte*>(this + 1); }
  void send(const Bytes& from) {
    std::memcpy(value(), from.data(), from.size());
    count.fetch_add(1, std::memory_order_release);
    syscall(SYS_futex, &count, FUTEX_WAKE, 1, nullptr, nullptr, 0);
  }
  /// Receives the value that comes after `seen` values.
  void receive(std::uint32_t seen, Bytes& to) {
    while (count.load(std::memory_order_acquire) == seen) {
      syscall(SYS_futex, &count, FUTEX_WAIT, seen, nullptr, nullptr, 0);
    }
    std::memcpy(to.data(), value(), to.size());
  }
};

struct Ways {
  Ways(std::byte* memory, std::size_t bytes)
      : there(*new (memory) Way), back(*new (memory + sizeBehind(bytes)) Way) {}
  static std::size_t sizeBehind(std::size_t bytes) {
    return sizeof(Way) + (bytes + sizeof(Way) - 1) / sizeof(Way) * sizeof(Way);
  }

  Way& there;
  Way& back;
};

void echo(const Ways& ways, std::size_t bytes, std::size_t rounds) {
  Bytes value(bytes);
  for (std::uint32_t i = 0; i < rounds; ++i) {
    ways.there.receive(i, value);
    ways.back.send(value);
  }
}

}  // namespace

std::vector<std::int64_t> bareMemoryRounds(std::size_t bytes, int cpu, std::size_t skip,
                                           std::size_t samples) {
  const Pinned pinned(cpu);
  const suture::MemoryBlock block("suture-bench", 2 * Ways::sizeBehind(bytes));
  const Ways ways(block.data(), bytes);
  const pid_t other = fork();
  if (other < 0) {
    throw suture::SetupError("a second process", std::strerror(errno), "Look at ulimit -u");
  }
  if (other == 0) {
    echo(ways, bytes, skip + samples);
    _exit(0);
  }
  std::vector<std::int64_t> elapsed;
  Bytes value(bytes, std::byte{0x5a});
  for (std::uint32_t i = 0; i < skip + samples; ++i) {
    const suture::Time begin = now();
    ways.there.send(value);
    ways.back.receive(i, value);
    if (i >= skip) elapsed.push_back((now() - begin).count());
  }
  waitpid(other, nullptr, 0);
  return elapsed;
}

}  // namespace bench
