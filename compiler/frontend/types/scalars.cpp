#include "compiler/frontend/types/scalars.h"

namespace suture::compiler::frontend {
namespace {

MappedType scalar(model::Scalar which, std::string spelling) {
  model::Type type;
  type.shape = model::Type::Shape::Scalar;
  type.scalar = which;
  type.spelling = std::move(spelling);
  return type;
}

}  // namespace

MappedType mapBuiltin(const clang::BuiltinType* type) {
  using clang::BuiltinType;
  using model::Scalar;
  switch (type->getKind()) {
    case BuiltinType::Bool: return scalar(Scalar::Bool, "bool");
    case BuiltinType::SChar: return scalar(Scalar::Int8, "std::int8_t");
    case BuiltinType::Short: return scalar(Scalar::Int16, "std::int16_t");
    case BuiltinType::Int: return scalar(Scalar::Int32, "std::int32_t");
    case BuiltinType::Long: return scalar(Scalar::Int64, "std::int64_t");
    case BuiltinType::UChar: return scalar(Scalar::UInt8, "std::uint8_t");
    case BuiltinType::UShort: return scalar(Scalar::UInt16, "std::uint16_t");
    case BuiltinType::UInt: return scalar(Scalar::UInt32, "std::uint32_t");
    case BuiltinType::ULong: return scalar(Scalar::UInt64, "std::uint64_t");
    case BuiltinType::Float: return scalar(Scalar::Float32, "float");
    case BuiltinType::Double: return scalar(Scalar::Float64, "double");
    case BuiltinType::LongLong:
    case BuiltinType::ULongLong:
      return TypeProblem{"long-long", "it is a type of its own beside std::int64_t",
                         "use std::int64_t or std::uint64_t"};
    case BuiltinType::Char_S:
    case BuiltinType::Char_U:
      return TypeProblem{"char", "whether char is signed differs between machines",
                         "use std::int8_t, or std::string for text"};
    case BuiltinType::Char8:
    case BuiltinType::Char16:
    case BuiltinType::Char32:
      return TypeProblem{"unsupported-type", "a single character has no form on the wire",
                         "use std::string for text, or an integer for a code"};
    case BuiltinType::NullPtr:
      return TypeProblem{"unsupported-type", "it has one value, so that it says nothing",
                         "leave it out, or add SUTURE_FIELD(skip())"};
    default:
      return TypeProblem{"unsupported-type", "its size differs between machines",
                         "use bool, a fixed-width integer, float or double"};
  }
}

MappedType mapForeignBuiltin(const clang::BuiltinType* type) {
  using clang::BuiltinType;
  using model::Scalar;
  switch (type->getKind()) {
    case BuiltinType::Char_S:
    case BuiltinType::Char_U: return scalar(Scalar::Int8, "char");
    case BuiltinType::LongLong: return scalar(Scalar::Int64, "long long");
    case BuiltinType::ULongLong: return scalar(Scalar::UInt64, "unsigned long long");
    default: return mapBuiltin(type);
  }
}

}  // namespace suture::compiler::frontend
