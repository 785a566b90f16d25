#pragma once
// This is the wire view of a C++ type: what the frontend understood and every later stage works on.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace suture::compiler::model {

/// Says where something was declared. `handle` is opaque to all but the frontend, which turns it
/// back into a clang location to draw the caret; `file` and `line` serve the artefacts.
struct Source {
  std::uint32_t handle = 0;
  std::string file;  ///< as the target's include path spells it: "arm/arm.h"
  unsigned line = 0;
};

enum class Scalar {
  Bool,
  Int8,
  Int16,
  Int32,
  Int64,
  UInt8,
  UInt16,
  UInt32,
  UInt64,
  Float32,
  Float64
};

enum class Clock { Steady, System };

/// A Type is one of a closed set of shapes. Beside each shape stands which members below `shape`
/// count.
struct Type {
  enum class Shape {
    Scalar,      ///< scalar
    Enum,        ///< name, of a model::Enum
    Struct,      ///< name, of a model::Struct
    Text,        ///< capacity
    Array,       ///< element, rows = length: std::array, T[N]
    List,        ///< element, capacity, distinct: a sequence, a set, an Eigen vector of any length
    Matrix,      ///< scalar, rows, columns: a fixed Eigen matrix or vector, column-major
    Quaternion,  ///< scalar; order w, x, y, z on the wire
    Isometry,    ///< Eigen::Isometry3d: rotation 3x3 and translation 3
    Affine,      ///< Eigen::Affine3d: the same numbers, any linear part
    Duration,    ///< scalar (rep), period: a chrono duration; Int64 ns on the wire, or its count
                 ///< as Float64 where the rep is real
    TimePoint,   ///< clock: Int64 ns on the wire
    Optional,    ///< element: std::optional, std::unique_ptr
    Map,         ///< element (key, value), capacity: std::map, std::unordered_map
    Tuple,       ///< element (each member): std::tuple, std::pair
    Variant,     ///< element (each alternative): std::variant
    Nothing,     ///< std::monostate
    AnyMatrix,   ///< scalar, capacity (rows), columnCapacity: an Eigen matrix of any size
  };

  Shape shape = Shape::Scalar;
  Scalar scalar = Scalar::Float64;
  std::string name;  ///< fully qualified C++ name, for Enum and Struct
  unsigned rows = 0, columns = 0;
  std::optional<unsigned> capacity;  ///< bound of this level; absent = unbounded
  std::optional<unsigned> columnCapacity;
  bool distinct = false;      ///< a set: no element twice
  bool bulk = false;          ///< a List or Matrix of numbers that travels as one block of bytes
  std::vector<Type> element;  ///< the types that it is made of, in order
  std::int64_t periodNumerator = 1, periodDenominator = 1;
  Clock clock = Clock::Steady;
  std::string spelling;  ///< how generated C++ writes the type: "std::vector<double>"

  bool operator==(const Type&) const = default;
};

}  // namespace suture::compiler::model
