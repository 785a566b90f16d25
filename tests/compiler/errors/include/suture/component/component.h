#pragma once
// Stand-ins for the runtime's names that suturec knows.
namespace suture {
class Component {
 public:
  virtual ~Component() = default;
};
class Device : public Component {};
class Task : public Component {};
class EventTask : public Task {};
}  // namespace suture
