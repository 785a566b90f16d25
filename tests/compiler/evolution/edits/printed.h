#pragma once
// The peers of both versions print so what they get.

#include <suture/base/errors.h>

#include <iostream>
#include <string>
#include <type_traits>

#include "tests/compiler/evolution/kinds_text.h"

namespace edits {

using evolution::text;

template <class T>
requires std::is_enum_v<T> std::string kindText(T value) {
  return std::to_string(static_cast<int>(value));
}

template <class T>
requires requires(const T& value) { value.a; }
std::string kindText(const T& value) { return "{" + text(value.a) + "}"; }

template <class Call>
void tell(const char* name, Call call) {
  const auto& answer = call.within(std::chrono::seconds(10));
  std::cout << name << ": " << (answer ? "done" : toString(answer.error())) << std::endl;
}

template <class Subscribed>
void hear(const char* name, const Subscribed& subscribed) {
  if (!subscribed) std::cout << "on " << name << ": " << toString(subscribed.error()) << std::endl;
}

inline void printEvent(const char* name, double value) {
  std::cout << "event " << name << " " << value << std::endl;
}

}  // namespace edits
