#include "rt/task_thread/system_calls.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <system_error>

#include "rt/task_thread/watch.h"

#ifndef __x86_64__
#error "Which registers a system call uses is known here for x86-64 only"
#endif

// This is the one place from which a system call is not trapped: the handler makes them here.
extern "C" long proof_system_call(long number, const long* arguments);
extern "C" const char proof_after_system_call;
asm(R"(
  .text
  .globl proof_system_call
  .type proof_system_call, @function
proof_system_call:
  mov %rdi, %rax
  mov %rsi, %r11
  mov (%r11), %rdi
  mov 8(%r11), %rsi
  mov 16(%r11), %rdx
  mov 24(%r11), %r10
  mov 32(%r11), %r8
  mov 40(%r11), %r9
  syscall
  .globl proof_after_system_call
proof_after_system_call:
  ret
  .size proof_system_call, . - proof_system_call
)");

namespace proof {
namespace {

// The kernel does not make a trapped call, and raises SIGSYS in its place, in the same thread.
void tellAndMake(int, siginfo_t*, void* context) {
  const int errorBefore = errno;
  auto& registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
  const long arguments[] = {registers[REG_RDI], registers[REG_RSI], registers[REG_RDX],
                            registers[REG_R10], registers[REG_R8],  registers[REG_R9]};
  const long number = registers[REG_RAX];
  Watch::noteSystemCall(number, arguments[0], arguments[1]);
  registers[REG_RAX] = proof_system_call(number, arguments);
  Watch::noteResult(number, arguments[1], registers[REG_RAX]);
  errno = errorBefore;
}

void check(bool good, const char* step) {
  if (!good) throw std::system_error(errno, std::generic_category(), step);
}

// SA_NODEFER is set because what the handler calls may make system calls of its own.
void handleTraps() {
  struct sigaction action {};
  action.sa_sigaction = tellAndMake;
  action.sa_flags = SA_SIGINFO | SA_NODEFER;
  check(sigaction(SIGSYS, &action, nullptr) == 0, "sigaction(SIGSYS)");
}

constexpr sock_filter load(std::size_t offset) {
  return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
}

constexpr sock_filter unlessEqual(std::uint64_t value, std::uint8_t skipped) {
  return BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(value), 0, skipped);
}

constexpr sock_filter answer(std::uint32_t action) { return BPF_STMT(BPF_RET | BPF_K, action); }

}  // namespace

void trapSystemCallsOfThisThread() {
  handleTraps();
  const auto place = reinterpret_cast<std::uint64_t>(&proof_after_system_call);
  constexpr std::size_t kPlace = offsetof(seccomp_data, instruction_pointer);
  sock_filter filter[] = {
      load(kPlace),
      unlessEqual(place & 0xffffffff, 3),
      load(kPlace + 4),
      unlessEqual(place >> 32, 1),
      answer(SECCOMP_RET_ALLOW),
      load(offsetof(seccomp_data, nr)),
      unlessEqual(SYS_rt_sigreturn, 1),  // the way back from the handler
      answer(SECCOMP_RET_ALLOW),
      answer(SECCOMP_RET_TRAP),
  };
  const sock_fprog program{sizeof(filter) / sizeof(*filter), filter};
  check(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0, "prctl(PR_SET_NO_NEW_PRIVS)");
  check(syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) == 0, "seccomp");
}

}  // namespace proof
