#pragma once
#include <suture/annotate.h>

#include <cstddef>
#include <cstdint>
#include <vector>
namespace demo {
using Count = std::int64_t;
struct SUTURE_TYPE() Fields {
  std::size_t size = 0;
  long whole = 0;
  std::vector<unsigned long> all;
  Count fine = 0;
  std::chrono::seconds also{0};
  int braces{};
};
}  // namespace demo
