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
  std::chrono::sys_seconds second;
  std::chrono::time_point<std::chrono::steady_clock, std::chrono::duration<double>> real;
};
}  // namespace demo
