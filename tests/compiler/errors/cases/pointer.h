#pragma once
#include <suture/annotate.h>
#include <memory>
namespace demo {
struct SUTURE_TYPE() Pointers {
  int* plain = nullptr;
  std::shared_ptr<int> shared;
  std::unique_ptr<int> unique;
};
}  // namespace demo
