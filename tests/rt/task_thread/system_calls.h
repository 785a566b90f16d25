#pragma once
// These show the system calls of a thread, seen from within the process.

namespace proof {

/// Tells from now on each system call of the calling thread first to Watch::noteSystemCall(), and
/// then makes it. It stays so until the thread ends; such a thread must not start others. Throws
/// std::system_error if the kernel refuses.
void trapSystemCallsOfThisThread();

}  // namespace proof
