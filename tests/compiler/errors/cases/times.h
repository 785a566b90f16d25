#pragma once
#include <suture/annotate.h>
#include <chrono>
#include <complex>
namespace demo {
struct SUTURE_TYPE() Times {
  std::chrono::duration<std::complex<double>> odd;
  std::chrono::duration<int, std::pico> fine;
  std::chrono::file_clock::time_point written;
  std::chrono::sys_days day;
};
}  // namespace demo
