#pragma once
// This runs a few threads in every order in which their accesses to shared memory can come.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace model {

/// This is one run of a scenario, on objects of its own. It has at most four threads; none may wait
/// for another in a loop, or own memory on its stack: a run may be given up half-way.
struct Run {
  std::vector<std::function<void()>> threads;
  std::function<void()> atEnd;  ///< after all threads have ended
};

struct Outcome {
  std::uint64_t runs = 0;      ///< to the end, no two of them alike
  std::uint64_t given_up = 0;  ///< found to be like another
  std::string violation;       ///< the broken rule, with the order of the threads' steps; "": none
};

/// Explores every order of the accesses, but only one of those that differ only in accesses that do
/// not matter to each other (different places, or both of them reads): sleep sets (Godefroid, LNCS
/// 1032, 1996). In each order it explores every value that a load may return under the memory
/// orders stated (memory.h).
Outcome explore(const std::function<Run()>& scenario);

// --- in a run

/// Ends the exploration unless `holds`.
void require(bool holds, const char* what);
/// Uses a word of plain memory, as a payload is, which the code under test must order.
void write(std::byte* word, std::uint64_t value);
std::uint64_t read(const std::byte* word);

// --- for what stands in for atomics and memcpy

/// Copies word by word: of plain memory, unless it is on the calling thread's stack.
void copy(std::byte* to, const std::byte* from, std::size_t size);

/// Says that the calling thread is about to access `place`; others may come first.
void access(const void* place, bool writes);
/// Returns a value that its load of `place` may see. `newest` is the last one stored.
std::uint64_t load(const void* place, std::uint64_t newest, bool acquires, bool newestOnly);
/// Stores its `value` to `place`, which had `old`.
void store(const void* place, std::uint64_t old, std::uint64_t value, bool releases,
           bool readModifyWrite);

}  // namespace model
