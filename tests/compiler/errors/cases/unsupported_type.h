#pragma once
#include <suture/annotate.h>
#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>
namespace demo {
struct SUTURE_TYPE() Unsupported {
  std::function<void()> callback;
  std::multimap<int, int> table;
  std::mutex guard;
  std::string_view text;
  std::u16string wide;
  std::vector<long double> precise;
  wchar_t letter = 0;
  char8_t sign = 0;
  std::nullptr_t nothing = nullptr;
};
}  // namespace demo
