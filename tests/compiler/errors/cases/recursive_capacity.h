#pragma once
#include <suture/annotate.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>
namespace demo {
struct Leaf;
struct SUTURE_TYPE() Branch {
  SUTURE_FIELD(capacity(3)) std::vector<Leaf> leaves;
};
struct SUTURE_TYPE() Leaf {
  SUTURE_FIELD(capacity(2, 8)) std::map<std::string, std::array<Branch, 2>> branches;
  std::vector<Branch> more;
  std::unique_ptr<Leaf> next;
};
}  // namespace demo
