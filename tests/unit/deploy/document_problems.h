#pragma once

#include <suture/deploy/document/json_document.h>

#include <functional>
#include <string>
#include <vector>

namespace suture {

using Texts = std::vector<std::string>;

/// Returns the problems of the DocumentError that `work` throws; none if it throws nothing.
inline Texts problemsOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const DocumentError& error) {
    return error.problems();
  }
  return {};
}

}  // namespace suture
