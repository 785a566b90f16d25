// The shape of ruckig's utils.hpp and result.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace ruckig {

constexpr static size_t DynamicDOFs{0};

template <class T, size_t DOFs>
using StandardVector =
    typename std::conditional<DOFs >= 1, std::array<T, DOFs>, std::vector<T>>::type;
template <class T, size_t DOFs, size_t SIZE>
using StandardSizeVector =
    typename std::conditional<DOFs >= 1, std::array<T, SIZE>, std::vector<T>>::type;

enum Result {
  Working = 0,
  Finished = 1,
  Error = -1,
  ErrorInvalidInput = -100,
  ErrorTrajectoryDuration = -101,
  ErrorPositionalLimits = -102,
  ErrorZeroLimits = -104,
  ErrorExecutionTimeCalculation = -110,
  ErrorSynchronizationCalculation = -111,
};

}  // namespace ruckig
