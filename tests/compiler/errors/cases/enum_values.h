#pragma once
#include <suture/annotate.h>
namespace demo {
enum class SUTURE_TYPE() Empty {};
enum class SUTURE_TYPE() Twice { One = 1, Uno = 1 };
}  // namespace demo
