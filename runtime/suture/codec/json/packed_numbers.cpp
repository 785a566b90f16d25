#include <suture/codec/json/json_integers.h>
#include <suture/codec/json/json_reals.h>
#include <suture/codec/json/packed_numbers.h>

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace suture::codec {
namespace {

/// Calls `use` with a number of the kind.
template <class Use>
auto withKind(const std::string& bulk, const Use& use) {
  if (bulk == "Float64") return use(double{});
  if (bulk == "Float32") return use(float{});
  if (bulk == "Int64") return use(std::int64_t{});
  if (bulk == "Int32") return use(std::int32_t{});
  if (bulk == "Int16") return use(std::int16_t{});
  if (bulk == "Int8") return use(std::int8_t{});
  if (bulk == "UInt64") return use(std::uint64_t{});
  if (bulk == "UInt32") return use(std::uint32_t{});
  if (bulk == "UInt16") return use(std::uint16_t{});
  return use(std::uint8_t{});
}

}  // namespace

Json numbersIn(std::span<const std::uint8_t> bytes, const std::string& bulk) {
  return withKind(bulk, [&](auto kind) {
    Json numbers = Json::array();
    for (; bytes.size() >= sizeof(kind); bytes = bytes.subspan(sizeof(kind))) {
      std::memcpy(&kind, bytes.data(), sizeof(kind));
      if constexpr (std::is_floating_point_v<decltype(kind)>) {
        numbers.push_back(realToJson(kind));
      } else {
        numbers.push_back(kind);
      }
    }
    return numbers;
  });
}

std::vector<std::uint8_t> bytesOf(const Json& numbers, const std::string& bulk) {
  if (!numbers.is_array()) throw std::invalid_argument("these are no list of numbers");
  return withKind(bulk, [&](auto kind) {
    std::vector<std::uint8_t> bytes;
    for (const Json& number : numbers) {
      if constexpr (std::is_floating_point_v<decltype(kind)>) {
        kind = realOf<decltype(kind)>(number).value();
      } else {
        kind = integerOf<decltype(kind)>(number).value();
      }
      const auto at = bytes.size();
      bytes.resize(at + sizeof(kind));
      std::memcpy(bytes.data() + at, &kind, sizeof(kind));
    }
    return bytes;
  });
}

}  // namespace suture::codec
