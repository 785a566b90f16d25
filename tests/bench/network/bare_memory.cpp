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

#include "bench/local/sample_server.h"
#include "bench/placement.h"

namespace bench {
namespace {

using robots::PoseSample;
using suture::now;

/// A Way is one direction: the value, and a number that counts it.
struct Way {
  std::atomic<std::uint32_t> count{0};
  alignas(64) char value[sizeof(PoseSample)];

  void send(const PoseSample& pose) {
    std::memcpy(value, static_cast<const void*>(&pose), sizeof(pose));
    count.fetch_add(1, std::memory_order_release);
    syscall(SYS_futex, &count, FUTEX_WAKE, 1, nullptr, nullptr, 0);
  }
  /// Receives the value that comes after `seen` values.
  void receive(std::uint32_t seen, PoseSample& pose) {
    while (count.load(std::memory_order_acquire) == seen) {
      syscall(SYS_futex, &count, FUTEX_WAIT, seen, nullptr, nullptr, 0);
    }
    std::memcpy(static_cast<void*>(&pose), value, sizeof(pose));
  }
};

struct Ways {
  Way there, back;
};

void echo(Ways& ways, std::size_t rounds) {
  PoseSample pose;
  for (std::uint32_t i = 0; i < rounds; ++i) {
    ways.there.receive(i, pose);
    ways.back.send(pose);
  }
}

}  // namespace

std::vector<std::int64_t> bareMemoryRounds(int cpu, std::size_t skip, std::size_t samples) {
  const Pinned pinned(cpu);
  const suture::MemoryBlock block("suture-bench", sizeof(Ways));
  auto& ways = *new (block.data()) Ways;
  const pid_t other = fork();
  if (other < 0) {
    throw suture::SetupError("a second process", std::strerror(errno), "Look at ulimit -u");
  }
  if (other == 0) {
    echo(ways, skip + samples);
    _exit(0);
  }
  std::vector<std::int64_t> elapsed;
  PoseSample pose = poseSample();
  for (std::uint32_t i = 0; i < skip + samples; ++i) {
    const suture::Time begin = now();
    ways.there.send(pose);
    ways.back.receive(i, pose);
    if (i >= skip) elapsed.push_back((now() - begin).count());
  }
  waitpid(other, nullptr, 0);
  return elapsed;
}

}  // namespace bench
