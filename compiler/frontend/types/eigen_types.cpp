#include "compiler/frontend/types/eigen_types.h"

#include <optional>

#include "compiler/frontend/types/scalars.h"

namespace suture::compiler::frontend {
namespace {

using Shape = model::Type::Shape;

using Specialisation = clang::ClassTemplateSpecializationDecl;

// These are Eigen's own constants, which are part of its stable interface.
constexpr std::int64_t kRowMajorBit = 1;
constexpr std::int64_t kIsometryMode = 1;
constexpr std::int64_t kAffineMode = 2;
constexpr std::int64_t kDynamic = -1;

// This bound is ours: how many coefficients a matrix of fixed size may have.
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

// Returns a name such as Eigen::Vector3d if the type has one, else the template written out.
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

/// Returns a name such as Eigen::VectorXd if the type has one, else the template written out.
std::string spellingOf(const Specialisation* type, const std::string& scalar) {
  const auto extent = [type](unsigned index) {
    const std::int64_t value = number(type, index);
    return value == kDynamic ? std::string("Eigen::Dynamic") : std::to_string(value);
  };
  const std::int64_t rows = number(type, 1), columns = number(type, 2);
  const bool open = number(type, 4) == rows && number(type, 5) == columns;
  if (open && scalar == "double") {
    if (rows == kDynamic && columns == kDynamic) return "Eigen::MatrixXd";
    if (rows == kDynamic && columns == 1) return "Eigen::VectorXd";
    if (rows == 1) return "Eigen::RowVectorXd";
  }
  std::string text = "Eigen::Matrix<" + scalar + ", " + extent(1) + ", " + extent(2);
  if (!open) {
    text += ", " + std::to_string(number(type, 3)) + ", " + extent(4) + ", " + extent(5);
  }
  return text + ">";
}

/// Returns the bound that the type itself has, or none.
std::optional<unsigned> boundOf(const Specialisation* type, unsigned index) {
  const std::int64_t most = number(type, index);
  return most == kDynamic ? std::nullopt : std::optional(static_cast<unsigned>(most));
}

/// Maps an Eigen type whose number of rows or columns is known only at run time. A vector becomes a
/// list of its coefficients, and a matrix with a fixed number of rows a list of its columns.
MappedType mapDynamic(const Specialisation* type, const model::Type& scalar) {
  const std::int64_t rows = number(type, 1), columns = number(type, 2);
  model::Type mapped;
  mapped.spelling = spellingOf(type, scalar.spelling);
  mapped.capacity = boundOf(type, columns == kDynamic && rows != kDynamic ? 5 : 4);
  if (rows == kDynamic && columns == kDynamic) {
    mapped.shape = Shape::AnyMatrix;
    mapped.scalar = scalar.scalar;
    mapped.columnCapacity = boundOf(type, 5);
    return mapped;
  }
  mapped.shape = Shape::List;
  if (rows == 1 || columns == 1) {
    mapped.element = {scalar};
    return mapped;
  }
  if (rows == kDynamic) {
    return TypeProblem{"dynamic-matrix", "its columns are fixed and its rows are not",
                       "fix the rows and leave the columns open, or use Eigen::MatrixXd"};
  }
  model::Type column = scalar;
  column.shape = Shape::Matrix;
  column.rows = static_cast<unsigned>(rows);
  column.columns = 1;
  column.spelling = spellingOf(column, scalar.spelling);
  mapped.element = {column};
  return mapped;
}

bool isDouble(const Specialisation* type) {
  return type->getTemplateArgs()[0].getAsType()->isSpecificBuiltinType(clang::BuiltinType::Double);
}

}  // namespace

MappedType mapMatrix(const Specialisation* type, const NamedTypes&) {
  const std::int64_t rows = number(type, 1), columns = number(type, 2), options = number(type, 3);
  const bool dynamic = rows == kDynamic || columns == kDynamic;
  if (rows > kLargestMatrix || columns > kLargestMatrix || rows * columns > kLargestMatrix) {
    return TypeProblem{"matrix-size",
                       "it has more than " + std::to_string(kLargestMatrix) + " coefficients",
                       "use std::vector<double> with capacity()"};
  }
  const bool vector = rows == 1 || columns == 1;
  const bool defaultOptions = options == (rows == 1 && columns != 1 ? kRowMajorBit : 0);
  const bool bounds = number(type, 4) == rows && number(type, 5) == columns;
  if (!defaultOptions || (!bounds && !dynamic)) {
    return TypeProblem{"matrix-options",
                       vector
                           ? "its storage options are not Eigen's default"
                           : "only Eigen's default storage, column-major and aligned, is supported",
                       "drop the options"};
  }
  MappedType mapped = scalarOf(type);
  if (auto* matrix = std::get_if<model::Type>(&mapped)) {
    if (dynamic) return mapDynamic(type, *matrix);
    const std::string scalar = matrix->spelling;
    matrix->shape = model::Type::Shape::Matrix;
    matrix->rows = static_cast<unsigned>(rows);
    matrix->columns = static_cast<unsigned>(columns);
    matrix->spelling = spellingOf(*matrix, scalar);
  }
  return mapped;
}

MappedType mapQuaternion(const Specialisation* type, const NamedTypes&) {
  if (!isDouble(type) || number(type, 1) != 0) {
    return TypeProblem{"unsupported-quaternion", "only Eigen::Quaterniond is supported",
                       "use Eigen::Quaterniond"};
  }
  model::Type mapped;
  mapped.shape = model::Type::Shape::Quaternion;
  mapped.spelling = "Eigen::Quaterniond";
  return mapped;
}

MappedType mapTransform(const Specialisation* type, const NamedTypes&) {
  const std::int64_t mode = number(type, 2);
  if (!isDouble(type) || number(type, 1) != 3 || number(type, 3) != 0 ||
      (mode != kIsometryMode && mode != kAffineMode)) {
    return TypeProblem{"unsupported-transform",
                       "only Eigen::Isometry3d and Eigen::Affine3d are supported",
                       "use Eigen::Isometry3d"};
  }
  const bool rigid = mode == kIsometryMode;
  model::Type mapped;
  mapped.shape = rigid ? model::Type::Shape::Isometry : model::Type::Shape::Affine;
  mapped.spelling = rigid ? "Eigen::Isometry3d" : "Eigen::Affine3d";
  return mapped;
}

}  // namespace suture::compiler::frontend
