#include <suture/names/describe.h>

namespace suture {
namespace {

template <class Interface>
std::vector<InterfaceRecord> describe(const std::vector<Interface*>& interfaces) {
  std::vector<InterfaceRecord> records;
  for (const Interface* one : interfaces) {
    records.push_back({one->name(), one->info().name, one->info().hash, one->frames()});
  }
  return records;
}

}  // namespace

std::vector<ComponentRecord> describeComponents(const Directory& directory) {
  std::vector<ComponentRecord> records;
  for (const Component* component : directory.components()) {
    records.push_back(
        {component->name(), describe(component->provided()), describe(component->required())});
  }
  return records;
}

}  // namespace suture
