#pragma once
// A required interface answers its read commands here, from the rows that have come and under the
// connection's contract.

#include <suture/base/sample.h>
#include <suture/component/required/attachment.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace suture {

/// Belongs to the thread of the component. Sets `device`, and answers nothing, if the provider is a
/// device in this process, which the caller must call directly.
class Reads final : private Attachment::User {
 public:
  explicit Reads(Attachment& attachment) : attachment_(attachment) { attachment.inform(*this); }
  Reads(const Reads&) = delete;
  Reads& operator=(const Reads&) = delete;

  /// Copies the newest result of `command` into `slot`.
  Sample<void> read(std::uint16_t command, std::byte* slot, bool& device);
  /// Copies the result that was the newest at `at`; a device keeps none.
  Sample<void> readAt(Time at, std::uint16_t command, std::byte* slot, bool& device);
  /// Copies the results of `commands` from one row, the newest or that at `at`, each into its slot.
  Sample<void> readRow(const Time* at, std::span<const std::uint16_t> commands,
                       std::span<std::byte* const> slots, bool& device);
  /// Returns true if `answer` stands for a value that is zero by contract.
  bool zeroes(const Sample<void>& answer) const;

 private:
  /// No row of the next connection has been read yet.
  void join() override { lastRead_ = Time{}; }

  Errc ask(std::uint16_t command, bool& device);
  unsigned columnOf(std::uint16_t command) const;
  /// Returns false for a copy that the contract does not admit.
  bool admits(std::uint16_t command, const std::byte* copy) const;
  /// Records the age of a value that has just been read from the row of `stamp`.
  void noteRead(Time stamp);
  /// Returns the answer of a read whose newest value is of `stamp`, under the connection's
  /// contract.
  Sample<void> judgeAge(Time stamp);
  /// Returns the answer of a read that met `error`: if the provider is lost, as the contract says.
  Sample<void> judgeLoss(Errc error, std::uint16_t command, std::byte* slot);
  /// Returns true if the connection's contract says what a read answers that meets `error`.
  bool ruledByContract(Errc error) const;
  Sample<void> fallBack(Fallback fallback, Errc error, Time stamp);

  Attachment& attachment_;
  Time lastRead_{};
  std::uint32_t repeatedReads_ = 0;
};

}  // namespace suture
