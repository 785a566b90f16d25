#pragma once
#include <suture/annotate.h>

#include <atomic>
#include <span>
#include <thread>
#include <vector>
namespace demo {
inline auto kCode = [] {};
struct SUTURE_TYPE() Fields {
  decltype(kCode) code;
  std::thread worker;
  std::atomic<int> counter;
  std::span<const double> view;
  std::vector<int>::iterator place;
  std::vector<int*> pointers;
};
}  // namespace demo
