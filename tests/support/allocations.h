#pragma once
// Counts what the calling thread takes from the heap: this program brings a malloc of its own in
// front of the C library's.

#include <cstdint>

namespace suture {

/// How often the calling thread has allocated. Always 0 where countsAllocations() is false.
std::uint64_t allocations();

/// False under a sanitizer, which needs malloc for itself.
bool countsAllocations();

}  // namespace suture
