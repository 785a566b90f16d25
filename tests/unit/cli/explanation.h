#pragma once
// This is what a process says of an interface robots::Gripper; tests spoil it.

#include <capnp/message.h>
#include <suture/session/provider/explain.h>

#include "robots/gripper.suture.h"

namespace suture::cli {

/// This is a message that explains the interface.
class Explained {
 public:
  Explained() { explain(interfaceInfo<robots::Gripper>(), message_.initRoot<wire::Explanation>()); }

  capnp::MallocMessageBuilder& message() { return message_; }
  wire::Explanation::Builder get() { return message_.getRoot<wire::Explanation>(); }

  template <class Type>
  capnp::schema::Node::Builder node() {
    for (auto one : get().getNodes()) {
      if (one.getId() == capnp::typeId<Type>()) return one;
    }
    throw std::runtime_error("there is no such node");
  }

 private:
  capnp::MallocMessageBuilder message_;
};

}  // namespace suture::cli
