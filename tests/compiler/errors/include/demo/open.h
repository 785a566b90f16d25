#pragma once
#include <suture/annotate.h>
#include <map>
#include <memory>
#include <string>
#include <vector>
// Contracts without bounds, for devices alone.
namespace demo {
struct SUTURE_TYPE() Node {
  std::unique_ptr<Node> next;
};
struct SUTURE_TYPE() Tree {
  SUTURE_FIELD(capacity(2)) std::vector<Tree> children;
};
struct SUTURE_TYPE() Joints {
  SUTURE_FIELD(capacity(8)) std::vector<std::string> name;
};
class SUTURE_INTERFACE() Forest {
 public:
  virtual ~Forest() = default;
  SUTURE_COMMAND() virtual void put(const Node& node) = 0;
  SUTURE_COMMAND() virtual const Tree& tree() const = 0;
};
class SUTURE_INTERFACE() Speech {
 public:
  virtual ~Speech() = default;
  SUTURE_COMMAND() virtual void move(const std::vector<Joints>& path) = 0;
  SUTURE_COMMAND() virtual void say(SUTURE_FIELD(capacity(9)) const std::string& text) = 0;
  SUTURE_COMMAND() virtual const Joints& measured() const = 0;
  SUTURE_EVENT() suture::EventOf<std::string> said;
};
}  // namespace demo
