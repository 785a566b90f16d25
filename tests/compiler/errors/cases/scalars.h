#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Scalars {
  char letter = 'a';
  long long big = 0;
  unsigned long long bigger = 0;
  __int128 biggest = 0;
};
enum class SUTURE_TYPE() Letter : char { A, B };
}  // namespace demo
