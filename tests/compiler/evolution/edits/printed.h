#pragma once
// The peers of both versions print so what they get.

#include <suture/base/errors.h>
#include <suture/base/time.h>

#include <chrono>
#include <iostream>
#include <string>
#include <thread>
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

/// Sends more commands that await no answer than any queue of the table has room for, each as soon
/// as there is room, and says why one could not be sent.
template <class Send>
void flood(const char* name, const Send& send) {
  const suture::Time deadline = suture::now() + std::chrono::seconds(10);
  for (int i = 0; i < 100; ++i) {
    auto sent = send();
    for (; !sent && sent.error() == suture::Errc::Full && suture::now() < deadline; sent = send()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (sent) continue;
    std::cout << "flood of " << name << ": " << toString(sent.error()) << std::endl;
    return;
  }
}

template <class Subscribed>
void hear(const char* name, const Subscribed& subscribed) {
  if (!subscribed) std::cout << "on " << name << ": " << toString(subscribed.error()) << std::endl;
}

template <class... Values>
void printEvent(const char* name, const Values&... values) {
  std::cout << "event " << name;
  ((std::cout << " " << text(values)), ...);
  std::cout << std::endl;
}

}  // namespace edits
