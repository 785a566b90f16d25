#pragma once
// The system calls of a thread, seen from within the process.

namespace proof {

/// From now on each system call of the calling thread is first told to Watch::noteSystemCall(), and
/// then made. Stays so until the thread ends; such a thread must not start others. Throws
/// std::system_error if the kernel refuses.
void trapSystemCallsOfThisThread();

}  // namespace proof
