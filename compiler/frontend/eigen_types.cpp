#include "compiler/frontend/eigen_types.h"

#include "compiler/frontend/scalars.h"

namespace suture::compiler::frontend {
namespace {

using Specialisation = clang::ClassTemplateSpecializationDecl;

// Eigen's own constants, part of its stable interface.
constexpr std::int64_t kRowMajorBit = 1;
constexpr std::int64_t kIsometryMode = 1;
constexpr std::int64_t kLargestMatrix = 1 << 16;

std::int64_t number(const Specialisation* type, unsigned index) {
  return type->getTemplateArgs()[index].getAsIntegral().getSExtValue();
}

MappedType scalarOf(const Specialisation* type) {
  const clang::QualType scalar = type->getTemplateArgs()[0].getAsType().getCanonicalType();
  const auto* builtin = scalar->getAs<clang::BuiltinType>();
  if (!builtin || builtin->getKind() == clang::BuiltinType::Bool) {
    return TypeProblem{"unsupported-matrix", "its scalar is not a plain number",
                       "use double, float or a fixed-width integer"};
  }
  return mapBuiltin(builtin);
}

// Eigen::Vector3d for what has such a name, else the template written out.
std::string spellingOf(const model::Type& matrix, const std::string& scalar) {
  const std::string letter = scalar == "double"         ? "d"
                             : scalar == "float"        ? "f"
                             : scalar == "std::int32_t" ? "i"
                                                        : "";
  const auto small = [](unsigned n) { return n >= 2 && n <= 4; };
  if (!letter.empty() && small(matrix.rows)) {
    if (matrix.columns == 1) return "Eigen::Vector" + std::to_string(matrix.rows) + letter;
    if (matrix.columns == matrix.rows) {
      return "Eigen::Matrix" + std::to_string(matrix.rows) + letter;
    }
  }
  return "Eigen::Matrix<" + scalar + ", " + std::to_string(matrix.rows) + ", " +
         std::to_string(matrix.columns) + ">";
}

bool isDouble(const Specialisation* type) {
  return type->getTemplateArgs()[0].getAsType()->isSpecificBuiltinType(clang::BuiltinType::Double);
}

}  // namespace

MappedType mapMatrix(const Specialisation* type) {
  const std::int64_t rows = number(type, 1), columns = number(type, 2), options = number(type, 3);
  if (rows <= 0 || columns <= 0) {
    return TypeProblem{"dynamic-matrix", "matrices of dynamic size are not supported yet",
                       "use a fixed size, or std::vector<double> with capacity()"};
  }
  if (rows > kLargestMatrix || columns > kLargestMatrix || rows * columns > kLargestMatrix) {
    return TypeProblem{"matrix-size",
                       "it has more than " + std::to_string(kLargestMatrix) + " coefficients",
                       "use std::vector<double> with capacity()"};
  }
  const bool vector = rows == 1 || columns == 1;
  const bool defaultOptions = options == (rows == 1 && columns != 1 ? kRowMajorBit : 0);
  if (!defaultOptions || number(type, 4) != rows || number(type, 5) != columns) {
    return TypeProblem{"matrix-options",
                       vector
                           ? "its storage options are not Eigen's default"
                           : "only Eigen's default storage, column-major and aligned, is supported",
                       "drop the options"};
  }
  MappedType mapped = scalarOf(type);
  if (auto* matrix = std::get_if<model::Type>(&mapped)) {
    const std::string scalar = matrix->spelling;
    matrix->shape = model::Type::Shape::Matrix;
    matrix->rows = static_cast<unsigned>(rows);
    matrix->columns = static_cast<unsigned>(columns);
    matrix->spelling = spellingOf(*matrix, scalar);
  }
  return mapped;
}

MappedType mapQuaternion(const Specialisation* type) {
  if (!isDouble(type) || number(type, 1) != 0) {
    return TypeProblem{"unsupported-quaternion", "only Eigen::Quaterniond is supported",
                       "use Eigen::Quaterniond"};
  }
  model::Type mapped;
  mapped.shape = model::Type::Shape::Quaternion;
  mapped.spelling = "Eigen::Quaterniond";
  return mapped;
}

MappedType mapTransform(const Specialisation* type) {
  if (!isDouble(type) || number(type, 1) != 3 || number(type, 2) != kIsometryMode ||
      number(type, 3) != 0) {
    return TypeProblem{"unsupported-transform", "only Eigen::Isometry3d is supported",
                       "use Eigen::Isometry3d"};
  }
  model::Type mapped;
  mapped.shape = model::Type::Shape::Isometry;
  mapped.spelling = "Eigen::Isometry3d";
  return mapped;
}

}  // namespace suture::compiler::frontend
