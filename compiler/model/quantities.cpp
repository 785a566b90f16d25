#include "compiler/model/quantities.h"

namespace suture::compiler::model {
namespace {

using Shape = Type::Shape;

/// Returns the type of what a container holds; null if the type is no container.
const Type* contentOf(const Type& type) {
  switch (type.shape) {
    case Shape::Array:
    case Shape::List:
    case Shape::Optional: return &type.element.front();
    case Shape::Map: return &type.element.back();
    default: return nullptr;
  }
}

}  // namespace

bool holdsNumbers(const Type& type) {
  if (const Type* content = contentOf(type)) return holdsNumbers(*content);
  if (type.shape == Shape::Scalar) return type.scalar != Scalar::Bool;
  return type.shape == Shape::Matrix || type.shape == Shape::AnyMatrix;
}

bool holdsQuantities(const Type& type) {
  if (const Type* content = contentOf(type)) return holdsQuantities(*content);
  return type.shape == Shape::Isometry || type.shape == Shape::Affine || holdsNumbers(type);
}

}  // namespace suture::compiler::model
