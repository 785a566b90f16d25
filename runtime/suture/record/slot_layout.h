#pragma once
// Where the values of a slot lie, known from a contract's self-description alone.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace suture {

/// A type of a contract as the slots of slot_forms.h lay it out. A value; set-up code makes it.
class SlotLayout {
 public:
  /// `type` as a self-description writes it, whose "structs" and "enums" are those of `contract`.
  /// Throws SetupError for a description that is not one.
  SlotLayout(const nlohmann::json& type, const nlohmann::json& contract);
  /// Several values one after the other: fields of a struct, or what an event carries.
  static SlotLayout ofFields(const nlohmann::json& fields, const nlohmann::json& contract);

  /// sizeof() and alignof() of the slot.
  std::size_t size() const { return size_; }
  std::size_t alignment() const { return alignment_; }

  /// The value in `slot`: as docs/types.md says that JSON parameters are written; durations in
  /// seconds, time points in ns, numbers that are not finite as null. Lists that claim to be longer
  /// than their capacity are cut.
  nlohmann::json toJson(const std::byte* slot) const;

 private:
  enum class Kind : std::uint8_t {
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
    Float64,
    Nanoseconds,
    Enum,
    Struct,
    Text,
    List,
    Map,
    Array,
    Rows,
    AnyMatrix,
    Transform,
    Optional,
    Tuple,
    Variant,
    Nothing
  };
  struct Part {
    std::string name;  // of a field
    std::size_t offset;
    std::shared_ptr<const SlotLayout> layout;
  };

  SlotLayout() = default;
  void readType(const nlohmann::json& type, const nlohmann::json& contract);
  void readScalar(const std::string& name);
  void readEnum(const std::string& name, const nlohmann::json& contract);
  void readMatrix(const nlohmann::json& type);
  void readTuple(const nlohmann::json& elements, std::size_t from, const nlohmann::json& contract);
  void readVariant(const nlohmann::json& alternatives, const nlohmann::json& contract);
  void addPart(std::string name, SlotLayout layout);
  void repeat(SlotLayout element, std::size_t count);
  void finish();

  const SlotLayout& element() const { return *parts_.front().layout; }
  nlohmann::json scalarToJson(const std::byte* slot) const;
  nlohmann::json structToJson(const std::byte* slot) const;
  nlohmann::json listToJson(const std::byte* first, std::size_t count) const;
  nlohmann::json rowsToJson(const std::byte* first, std::size_t rows, std::size_t columns) const;
  nlohmann::json tupleToJson(const std::byte* slot) const;

  Kind kind_ = Kind::Nothing;
  std::size_t size_ = 0, alignment_ = 1;
  std::vector<Part> parts_;
  std::size_t count_ = 0;    // capacity, length, or rows
  std::size_t columns_ = 1;  // of a matrix
  double seconds_ = 1;       // of one count of a duration of real representation
  std::vector<std::pair<std::int64_t, std::string>> enumerators_;
};

}  // namespace suture
