#pragma once
// This reads several values of one row, that is of one cycle of the provider, by one call.
//
//   if (const auto row = readTogether(arm_.measured_cp, arm_.measured_js)) {
//     const auto& [pose, joints] = *row;
//   }
//
// All reads belong to one required interface and its thread, else the answer is Errc::Invalid. If
// one of them has no value, there is no row. A device in this process answers one after the other.

#include <suture/base/sample.h>
#include <suture/component/commands.h>

#include <array>
#include <tuple>
#include <utility>

namespace suture {

/// RowReader is the common part of the functions below; users do not call it.
class RowReader {
 public:
  template <auto... Methods, class... Slots>
  static Sample<void> read(const Time* at,
                           std::tuple<typename ReadCommand<Methods, Slots>::Value&...> into,
                           ReadCommand<Methods, Slots>&... reads) {
    return readEach(std::index_sequence_for<Slots...>{}, at, into, reads...);
  }

 private:
  template <std::size_t... I, class Into, class First, class... Others>
  static Sample<void> readEach(std::index_sequence<I...>, const Time* at, Into& into, First& first,
                               Others&... others) {
    RequiredParts& required = first.required_;
    if (((&others.required_ != &required) || ...)) return Errc::Invalid;
    std::tuple<LooseSlot<typename First::Slot>, LooseSlot<typename Others::Slot>...> slots;
    const std::array<std::uint16_t, sizeof...(I)> commands{first.id_, others.id_...};
    const std::array<std::byte*, sizeof...(I)> memory{std::get<I>(slots).memory()...};
    bool device = false;
    Sample<void> row = required.reads.readRow(at, commands, memory, device);
    if (device)
      return readDevice(at, into, std::tie(first, others...), std::index_sequence<I...>{});
    if (required.reads.zeroes(row)) {
      (load(std::get<I>(slots).zero(), std::get<I>(into)), ...);
    } else if (row.carriesValue()) {
      (load(std::get<I>(slots).value(), std::get<I>(into)), ...);
    }
    return row;
  }

  template <class Into, class Reads, std::size_t... I>
  static Sample<void> readDevice(const Time* at, Into& into, Reads reads,
                                 std::index_sequence<I...>) {
    if (at != nullptr && *at < now()) return Errc::TooOld;
    Sample<void> last = Errc::Invalid;
    const bool all = ((last = std::get<I>(reads).readDevice(std::get<I>(into))).hasValue() && ...);
    return all ? Sample<void>(now()) : last;
  }
};

/// Reads the newest row into objects that keep their memory. If there is no row, some may have been
/// written, but only if the provider is a device in this process.
///   readInto(std::tie(pose_, joints_), arm_.measured_cp, arm_.measured_js)
template <auto... Methods, class... Slots>
Sample<void> readInto(std::tuple<typename ReadCommand<Methods, Slots>::Value&...> into,
                      ReadCommand<Methods, Slots>&... reads) {
  return RowReader::read(nullptr, into, reads...);
}

/// Does the same with the last row at or before `time`; see ReadCommand::at().
template <auto... Methods, class... Slots>
Sample<void> readIntoAt(Time time, std::tuple<typename ReadCommand<Methods, Slots>::Value&...> into,
                        ReadCommand<Methods, Slots>&... reads) {
  return RowReader::read(&time, into, reads...);
}

/// Returns the newest row. Allocates only if its values do, or at the first call if more than two
/// of them are larger than 4 KiB.
template <auto... Methods, class... Slots>
auto readTogether(ReadCommand<Methods, Slots>&... reads)
    -> Sample<std::tuple<typename ReadCommand<Methods, Slots>::Value...>> {
  std::tuple<typename ReadCommand<Methods, Slots>::Value...> values;
  const Sample<void> row =
      std::apply([&](auto&... value) { return readInto(std::tie(value...), reads...); }, values);
  return {row, std::move(values)};
}

/// Returns the last row at or before `time`; see ReadCommand::at().
template <auto... Methods, class... Slots>
auto readTogetherAt(Time time, ReadCommand<Methods, Slots>&... reads)
    -> Sample<std::tuple<typename ReadCommand<Methods, Slots>::Value...>> {
  std::tuple<typename ReadCommand<Methods, Slots>::Value...> values;
  const Sample<void> row = std::apply(
      [&](auto&... value) { return readIntoAt(time, std::tie(value...), reads...); }, values);
  if (!row) return row.error();
  return {std::move(values), row.stamp()};
}

}  // namespace suture
