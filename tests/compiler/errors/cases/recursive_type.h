#pragma once
#include <suture/annotate.h>
#include <vector>
namespace demo {
struct SUTURE_TYPE() Node {
  std::vector<Node> children;
};
}  // namespace demo
