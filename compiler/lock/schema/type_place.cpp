#include "compiler/lock/schema/type_place.h"

#include <algorithm>

namespace suture::compiler::lock {
namespace {

struct Range {
  std::size_t begin, end;
};

Range leafIn(const std::string& type) {
  const std::size_t begin = type.rfind('(') + 1;  // it is 0 if there is no list
  return {begin, std::min(type.find(')'), type.size())};
}

}  // namespace

std::string leafOf(const std::string& type) {
  const auto [begin, end] = leafIn(type);
  return type.substr(begin, end - begin);
}

std::string withLeaf(const std::string& type, const std::string& leaf) {
  const auto [begin, end] = leafIn(type);
  return type.substr(0, begin) + leaf + type.substr(end);
}

TypePlace placeOf(const std::string& type, const std::string& inside) {
  const std::string leaf = leafOf(type);
  const std::size_t colon = leaf.find(':');
  if (!leaf.starts_with('/') || colon == std::string::npos) return {inside, leaf};
  return {leaf.substr(1, colon - 1), leaf.substr(colon + 1)};
}

}  // namespace suture::compiler::lock
