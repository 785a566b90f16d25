#include "cli/contract/schema_guard.h"

#include <cstdint>
#include <map>

namespace suture::cli {
namespace {

using capnp::schema::Field;
using capnp::schema::Node;
using WireType = capnp::schema::Type;

constexpr std::uint64_t kWordBits = 64, kDiscriminantBits = 16;

/// Returns the bits of a value in the data section of its struct; 0: it has none there.
std::uint64_t bitsOf(WireType::Reader type) {
  switch (type.which()) {
    case WireType::BOOL: return 1;
    case WireType::INT8:
    case WireType::UINT8: return 8;
    case WireType::INT16:
    case WireType::UINT16:
    case WireType::ENUM: return 16;
    case WireType::INT32:
    case WireType::UINT32:
    case WireType::FLOAT32: return 32;
    case WireType::INT64:
    case WireType::UINT64:
    case WireType::FLOAT64: return 64;
    default: return 0;
  }
}

bool fits(std::uint64_t offset, std::uint64_t bits, Node::Struct::Reader owner) {
  return (offset + 1) * bits <= owner.getDataWordCount() * kWordBits;
}

bool isSound(Field::Slot::Reader slot, Node::Struct::Reader owner) {
  const std::uint64_t bits = bitsOf(slot.getType());
  if (bits != 0 || slot.getType().isVoid()) return fits(slot.getOffset(), bits, owner);
  return slot.getOffset() < owner.getPointerCount();
}

class Guard {
 public:
  explicit Guard(capnp::List<Node>::Reader nodes) {
    for (const auto node : nodes) {
      if (node.isStruct()) structs_.emplace(node.getId(), node);
    }
  }

  std::optional<std::string> fault() const {
    for (const auto& [id, node] : structs_) {
      const auto layout = node.getStruct();
      const bool chosen = layout.getDiscriminantCount() == 0 ||
                          fits(layout.getDiscriminantOffset(), kDiscriminantBits, layout);
      if (!chosen) return "the union of " + nameOf(node) + " lies outside of it";
      for (const auto field : layout.getFields()) {
        const bool sound = field.isGroup() ? isGroupOf(node, field.getGroup().getTypeId())
                                           : isSound(field.getSlot(), layout);
        if (!sound)
          return "'" + std::string(field.getName().cStr()) + "' lies outside of " + nameOf(node);
      }
    }
    return std::nullopt;
  }

 private:
  static std::string nameOf(Node::Reader node) { return node.getDisplayName().cStr(); }

  /// Returns true if `id` is a group of `owner`: it shares the owner's memory, and is part of no
  /// other.
  bool isGroupOf(Node::Reader owner, std::uint64_t id) const {
    const auto found = structs_.find(id);
    if (found == structs_.end() || found->second.getScopeId() != owner.getId()) return false;
    const auto group = found->second.getStruct(), whole = owner.getStruct();
    return group.getIsGroup() && group.getDataWordCount() == whole.getDataWordCount() &&
           group.getPointerCount() == whole.getPointerCount();
  }

  std::map<std::uint64_t, Node::Reader> structs_;
};

}  // namespace

std::optional<std::string> faultIn(capnp::List<Node>::Reader nodes) { return Guard(nodes).fault(); }

}  // namespace suture::cli
