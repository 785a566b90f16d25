#include "rt/task_thread/watch.h"

#include <cxxabi.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <linux/futex.h>
#include <sys/resource.h>
#include <sys/syscall.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <utility>

#include "rt/task_thread/system_calls.h"

namespace proof {
namespace {

// This watch looks at the calling thread. It is null while a finding is written down, since that
// may do what is watched for.
constinit thread_local Watch* current = nullptr;

// The kernel moves pages of busy machines to other places (compaction, huge pages) and takes pages
// of files back, and whoever touches one next has a fault that no code of ours has made. So few are
// put down to that, and only if the kernel says that it has done so meanwhile.
constexpr std::uint64_t kMovedPages = 3;

/// Returns how many pages the kernel has moved or taken back since the machine started.
std::uint64_t movedPages() {
  std::ifstream counts("/proc/vmstat");
  std::uint64_t sum = 0, count = 0;
  for (std::string name; counts >> name >> count;) {
    const bool moves = name == "pgmigrate_success" || name == "thp_collapse_alloc" ||
                       name == "pgsteal_kswapd" || name == "pgsteal_direct";
    if (moves) sum += count;
  }
  return sum;
}

std::uint64_t pageFaults() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return static_cast<std::uint64_t>(usage.ru_minflt + usage.ru_majflt);
}

/// Returns the function at `address`; "" if it has no name that other files can see.
std::string functionAt(void* address) {
  Dl_info info{};
  if (dladdr(address, &info) == 0 || info.dli_sname == nullptr) return "";
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> readable(
      abi::__cxa_demangle(info.dli_sname, nullptr, nullptr, &status), &std::free);
  return status == 0 ? readable.get() : info.dli_sname;
}

}  // namespace

Watch::Watch(std::string thread, std::uint64_t warmUp, std::uint64_t cycles, Allowance allowance)
    : thread_(std::move(thread)), warmUp_(warmUp), cycles_(cycles), allowance_(allowance) {}

void Watch::cycle() {
  ++cycle_;
  sleeps_ = wakes_ = 0;
  if (cycle_ == warmUp_) begin();
  if (cycle_ == warmUp_ + cycles_) end();
}

void Watch::begin() {
  void* frames[kMaxFrames];
  backtrace(frames, kMaxFrames);  // the first one loads a library
  trapSystemCallsOfThisThread();
  movedBefore_ = movedPages();
  faultsBefore_ = pageFaults();
  current = this;
}

void Watch::end() {
  current = nullptr;
  const std::uint64_t faults = pageFaults() - faultsBefore_;
  const bool moved = movedPages() != movedBefore_;
  if (faults > (moved ? kMovedPages : 0)) {
    record("page fault");
    findings_.back().count = faults;
    findings_.back().frameCount = 0;  // no watch saw where
  }
  done_.store(true, std::memory_order_release);
}

void Watch::noteCall(const char* function) {
  Watch* watch = std::exchange(current, nullptr);
  if (watch == nullptr) return;
  watch->record(function);
  current = watch;
}

void Watch::noteSystemCall(long number, long first, long second) {
  Watch* watch = std::exchange(current, nullptr);
  if (watch == nullptr) return;
  if (!watch->allowed(number, first, second)) watch->record("system call ", number);
  current = watch;
}

bool Watch::allowed(long number, long address, long operation) {
  if (number != SYS_futex) return false;
  switch (operation & FUTEX_CMD_MASK) {
    case FUTEX_WAIT:
    case FUTEX_WAIT_BITSET: return allowedSleep();
    case FUTEX_WAKE: return allowedWake(address);
    default: return false;
  }
}

// The kernel refuses to let a thread sleep that was rung meanwhile. The wake of that ring may still
// come and end a later sleep for nothing, so each refusal allows one more sleep.
bool Watch::allowedSleep() {
  if (++sleeps_ <= allowance_.sleeps) return true;
  if (lateWakes_ == 0) return false;
  --lateWakes_;
  return true;
}

void Watch::noteResult(long number, long second, long result) {
  if (current == nullptr || number != SYS_futex || result != -EAGAIN) return;
  const long operation = second & FUTEX_CMD_MASK;
  if (operation == FUTEX_WAIT || operation == FUTEX_WAIT_BITSET) ++current->lateWakes_;
}

bool Watch::allowedWake(long address) {
  if (wakes_ >= std::min<std::size_t>(allowance_.wakes, kMaxWoken)) return false;
  if (std::find(woken_, woken_ + wakes_, address) != woken_ + wakes_) return false;
  woken_[wakes_++] = address;
  return true;
}

void Watch::record(const char* what, long number) {
  const std::uint64_t faults = pageFaults();
  std::string name = number < 0 ? what : what + std::to_string(number);
  auto found = std::find_if(findings_.begin(), findings_.end(),
                            [&](const Finding& finding) { return finding.what == name; });
  if (found == findings_.end()) {
    Finding& finding = findings_.emplace_back();
    finding.what = std::move(name);
    finding.frameCount = backtrace(finding.frames, kMaxFrames);
    found = findings_.end() - 1;
  }
  ++found->count;
  faultsBefore_ += pageFaults() - faults;  // those are the watch's own
}

std::vector<std::string> Watch::findings() const {
  std::vector<std::string> lines;
  for (const Finding& finding : findings_) lines.push_back(describe(finding));
  return lines;
}

std::string Watch::describe(const Finding& finding) const {
  std::string line = thread_ + ": " + finding.what + ", " + std::to_string(finding.count) +
                     " times in " + std::to_string(cycles_) + " cycles";
  for (int i = 0; i < finding.frameCount; ++i) {
    const std::string function = functionAt(finding.frames[i]);
    if (!function.empty() && !function.starts_with("proof::Watch::")) line += "\n    " + function;
  }
  return line;
}

}  // namespace proof
