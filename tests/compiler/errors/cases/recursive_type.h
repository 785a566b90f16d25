#pragma once
#include <suture/annotate.h>
#include <map>
#include <memory>
#include <string>
#include <vector>
namespace demo {
struct SUTURE_TYPE() Node {
  std::unique_ptr<Node> next;
};
struct SUTURE_TYPE() Tree {
  SUTURE_FIELD(capacity(2)) std::vector<Tree> children;
};
struct SUTURE_TYPE() Fine {
  std::map<std::string, Fine> children;
};
class SUTURE_INTERFACE() Contract {
 public:
  virtual ~Contract() = default;
  SUTURE_COMMAND() virtual void put(const Node& node) = 0;
  SUTURE_COMMAND() virtual const Tree& tree() const = 0;
};
}  // namespace demo
