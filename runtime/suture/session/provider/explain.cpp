#include <capnp/schema.h>
#include <suture/codec/codec.h>
#include <suture/session/provider/explain.h>

#include <map>
#include <vector>

namespace suture {
namespace {

/// Collects a schema and all that it depends on, each once.
class Closure {
 public:
  explicit Closure(capnp::Schema root) { add(root); }

  const std::map<std::uint64_t, capnp::Schema>& schemas() const { return schemas_; }

 private:
  void add(capnp::Schema schema) {
    const auto node = schema.getProto();
    if (!schemas_.emplace(node.getId(), schema).second) return;
    if (node.isStruct()) {
      for (const auto field : schema.asStruct().getFields()) addType(field.getType());
    } else if (node.isInterface()) {
      for (const auto base : schema.asInterface().getSuperclasses()) add(base);
      for (const auto method : schema.asInterface().getMethods()) {
        add(method.getParamType());
        add(method.getResultType());
      }
    }
  }

  void addType(capnp::Type type) {
    while (type.isList()) type = type.asList().getElementType();
    if (type.isStruct()) add(type.asStruct());
    if (type.isEnum()) add(type.asEnum());
    if (type.isInterface()) add(type.asInterface());
  }

  std::map<std::uint64_t, capnp::Schema> schemas_;
};

/// Turns "robot_types/pose.capnp:PoseStamped" into "PoseStamped", because no peer needs the file's
/// name.
void nameWithoutFile(capnp::schema::Node::Builder node) {
  const kj::String whole = kj::heapString(node.asReader().getDisplayName());
  KJ_IF_MAYBE (colon, whole.findLast(':')) {
    const auto cut = static_cast<std::uint32_t>(*colon) + 1;
    const std::uint32_t prefix = node.getDisplayNamePrefixLength();
    node.setDisplayName(whole.slice(cut));
    node.setDisplayNamePrefixLength(prefix > cut ? prefix - cut : 0);
  }
}

void setBases(const InterfaceInfo& info, wire::Explanation::Builder out) {
  std::vector<const char*> bases;
  for (const InterfaceInfo* one = &info; one->base != nullptr;) {
    one = &one->base();
    bases.push_back(one->description);
  }
  auto texts = out.initBases(static_cast<unsigned>(bases.size()));
  for (unsigned i = 0; i < bases.size(); ++i) texts.set(i, bases[i]);
}

}  // namespace

void explain(const InterfaceInfo& info, wire::Explanation::Builder out) {
  const capnp::InterfaceSchema contract = info.codec().schema();
  const Closure closure(contract);
  out.setDescription(info.description);
  out.setContract(contract.getProto().getId());
  auto nodes = out.initNodes(static_cast<unsigned>(closure.schemas().size()));
  unsigned i = 0;
  for (const auto& [id, schema] : closure.schemas()) {
    nodes.setWithCaveats(i, schema.getProto());
    nameWithoutFile(nodes[i++]);
  }
  setBases(info, out);
}

}  // namespace suture
