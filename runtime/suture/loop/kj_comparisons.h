#pragma once
// Include this before any header of capnp: it lets compilers that follow today's C++20 read them.
//
// KJ 0.9.2 leaves ("text" == StringPtr) to the reversed candidates of C++20. The standard took
// those back where a class declares operator!= as well (P2468), which KJ's does; capnp/blob.h then
// does not compile. g++ 12 has not followed yet, g++ 13 and clang 16 have.

#include <kj/string.h>

#if __cpp_impl_three_way_comparison
namespace kj {
inline bool operator==(const char* a, const StringPtr& b) { return StringPtr(a) == b; }
inline bool operator!=(const char* a, const StringPtr& b) { return StringPtr(a) != b; }
}  // namespace kj
#endif
