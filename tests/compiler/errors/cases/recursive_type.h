#pragma once
#include <suture/annotate.h>
#include <suture/component/component.h>
#include <suture/component/provided.h>
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
class SUTURE_COMPONENT() Registry : public suture::Device, public Contract {
  suture::Provided<Contract> fine_{*this, "Fine", *this};
};
class SUTURE_COMPONENT() Planner : public suture::EventTask, public Contract {
  suture::Provided<Contract> trees_{*this, "Trees", *this};
};
}  // namespace demo
