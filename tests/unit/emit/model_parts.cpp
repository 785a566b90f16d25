#include "tests/unit/emit/model_parts.h"

#include "compiler/model/naming.h"

namespace suture::compiler::sample {

using model::CommandKind;
using model::Scalar;
using model::Type;

namespace {

const char* cxxScalar(Scalar scalar) {
  switch (scalar) {
    case Scalar::Bool: return "bool";
    case Scalar::Int8: return "std::int8_t";
    case Scalar::Int16: return "std::int16_t";
    case Scalar::Int32: return "std::int32_t";
    case Scalar::Int64: return "std::int64_t";
    case Scalar::UInt8: return "std::uint8_t";
    case Scalar::UInt16: return "std::uint16_t";
    case Scalar::UInt32: return "std::uint32_t";
    case Scalar::UInt64: return "std::uint64_t";
    case Scalar::Float32: return "float";
    case Scalar::Float64: return "double";
  }
  return "";
}

Type shaped(Type::Shape shape, std::string spelling) {
  Type type;
  type.shape = shape;
  type.spelling = std::move(spelling);
  return type;
}

}  // namespace

Type scalar(Scalar scalar) {
  Type type = shaped(Type::Shape::Scalar, cxxScalar(scalar));
  type.scalar = scalar;
  return type;
}

Type number() { return scalar(Scalar::Float64); }

Type text(unsigned capacity) {
  Type type = shaped(Type::Shape::Text, "std::string");
  type.capacity = capacity;
  return type;
}

Type listOf(Type element, unsigned capacity) {
  Type type = shaped(Type::Shape::List, "std::vector<" + element.spelling + ">");
  type.capacity = capacity;
  type.element = {std::move(element)};
  return type;
}

Type arrayOf(Type element, unsigned length) {
  Type type = shaped(Type::Shape::Array,
                     "std::array<" + element.spelling + ", " + std::to_string(length) + ">");
  type.rows = length;
  type.element = {std::move(element)};
  return type;
}

Type matrix(unsigned rows, unsigned columns, Scalar scalar) {
  const char* const letter = scalar == Scalar::Float64 ? "d" : "f";
  std::string spelling = std::string("Eigen::Matrix<") + cxxScalar(scalar) + ", " +
                         std::to_string(rows) + ", " + std::to_string(columns) + ">";
  if (rows <= 4 && columns == 1) spelling = "Eigen::Vector" + std::to_string(rows) + letter;
  if (rows <= 4 && columns == rows) spelling = "Eigen::Matrix" + std::to_string(rows) + letter;
  Type type = shaped(Type::Shape::Matrix, spelling);
  type.scalar = scalar;
  type.rows = rows;
  type.columns = columns;
  return type;
}

Type quaternion() { return shaped(Type::Shape::Quaternion, "Eigen::Quaterniond"); }
Type isometry() { return shaped(Type::Shape::Isometry, "Eigen::Isometry3d"); }

Type milliseconds() {
  Type type = shaped(Type::Shape::Duration, "std::chrono::milliseconds");
  type.scalar = Scalar::Int64;
  type.periodDenominator = 1000;
  return type;
}

Type steadyTime() {
  return shaped(Type::Shape::TimePoint, "std::chrono::steady_clock::time_point");
}

Type enumeration(const std::string& name) {
  Type type = shaped(Type::Shape::Enum, name);
  type.name = name;
  return type;
}

Type record(const std::string& name) {
  Type type = shaped(Type::Shape::Struct, name);
  type.name = name;
  return type;
}

model::Field field(const std::string& name, Type type, const std::string& unit) {
  model::Field result;
  result.name = name;
  result.wireName = model::camelCase(name);
  result.type = std::move(type);
  result.unit = unit;
  return result;
}

model::Struct structure(const std::string& name, std::vector<model::Field> fields) {
  model::Struct result;
  result.name = name;
  result.wireName = model::unqualified(name);
  result.fields = std::move(fields);
  return result;
}

model::Enum enumerated(const std::string& name,
                       std::initializer_list<std::pair<const char*, std::int64_t>> enumerators) {
  model::Enum result;
  result.name = name;
  result.wireName = model::unqualified(name);
  for (const auto& [enumerator, value] : enumerators) {
    result.enumerators.push_back({enumerator, model::camelCase(enumerator), value, {}, {}});
  }
  return result;
}

model::Command command(const std::string& name, CommandKind kind) {
  model::Command result;
  result.name = name;
  result.wireName = model::camelCase(name);
  result.kind = kind;
  return result;
}

model::Command read(const std::string& name, Type result) {
  model::Command one = command(name, CommandKind::Read);
  one.result = std::move(result);
  return one;
}

model::Command write(const std::string& name, const std::string& parameter, Type type) {
  model::Command one = command(name, CommandKind::Write);
  model::Parameter only;
  only.name = parameter;
  only.wireName = model::camelCase(parameter);
  only.byReference =
      type.shape != Type::Shape::Scalar && type.shape != Type::Shape::Enum;  // as the headers do
  only.type = std::move(type);
  one.parameters = {std::move(only)};
  return one;
}

model::Event event(const std::string& name, std::vector<Type> payload) {
  model::Event result;
  result.member = name + "_event";
  result.name = name;
  result.wireName = model::camelCase(name);
  result.payload = std::move(payload);
  return result;
}

}  // namespace suture::compiler::sample
