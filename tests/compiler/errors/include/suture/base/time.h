#pragma once
#include <chrono>
namespace suture {
using Time = std::chrono::steady_clock::time_point;
}
