#pragma once

namespace peers {

/// Makes the compiler assume that the value is read and changed here, so that it keeps all the code
/// that computes the value.
template <class T>
void keep(T& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

}  // namespace peers
