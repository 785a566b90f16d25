#pragma once
#include <suture/annotate.h>
namespace demo {
enum class SUTURE_TYPE() Mode { Off, eof, overflow };
}  // namespace demo
