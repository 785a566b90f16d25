#pragma once
#include <suture/annotate.h>
#include <memory>
namespace demo {
class Later;
struct SUTURE_TYPE() Pointers {
  int* plain = nullptr;
  std::shared_ptr<int> shared;
  std::unique_ptr<int> unique;
  const char* label = "grip";
  const char16_t* wide;
  const void* any;
  long long* big;
  Later* later;
  Pointers* next;
};
}  // namespace demo
