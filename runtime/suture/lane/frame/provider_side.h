#pragma once
// The provider's side of a frame connection: the client endpoint of a channel.

#include <suture/lane/frame/connection.h>
#include <suture/lane/frame/payloads/row_copy.h>

#include <array>
#include <cstdint>
#include <vector>

namespace suture::frame {

/// Puts the commands that arrive into the provider's channel in their order, and sends what the
/// provider answers, emits and publishes. Belongs to the lane thread.
class ProviderSide final : public Connection {
 public:
  /// Stands for a command that the contract does not have.
  static constexpr std::uint16_t kUnknown = 0xffff;

  /// `channel`'s client doorbell is the lane thread's. `commands`: by the number that the client
  /// gives a command, its number here, or kUnknown; empty if the two have the same numbers.
  ProviderSide(std::shared_ptr<Channel> channel, std::unique_ptr<Payloads> payloads,
               std::uint32_t number, std::vector<std::uint16_t> commands = {});

  /// Before it is carried: only what reads is taken, a command is refused (Errc::NotPermitted).
  void setReadOnly() { readOnly_ = true; }

 private:
  bool take(const Header& header, std::span<std::byte> payload) override;
  void taken() override;
  bool give() override;
  void letGo(Kind kind) override;

  bool takeCommand(const Header& header, std::span<std::byte> payload);
  Errc whyNot(std::uint16_t command) const;
  Errc post(const Header& header, std::uint16_t command, const std::byte* arguments);
  bool refuse(const Header& header, Errc error);
  bool takeSubscription(const Header& header, std::span<const std::byte> payload);

  void giveReplies();
  void giveRefusals();
  void giveTally();
  void giveCredits();
  void giveEvents();
  bool giveRow();
  bool wanted(const rt::EventRecord& record) const;

  bool readOnly_ = false;
  bool heard_ = false;  // the client's side: from then on it is there
  const std::vector<std::uint16_t> commands_;
  std::vector<std::uint32_t> waiting_;  // by the client's number of a command: credits that the
                                        // client has not got back
  Tally tally_;                         // as the client's side has been told
  struct RefusedCall {
    std::uint32_t call;
    Errc error;
  };
  std::array<RefusedCall, Channel::kMaxCalls> refusedCalls_;  // the client not yet told
  std::size_t refusedCallCount_ = 0;
  bool work_ = false;  // the provider is to be rung
  std::uint32_t subscription_ = 0;
  std::vector<Time> since_;  // by event: when it was subscribed to
  rt::ColumnSet columns_ = 0;
  std::uint64_t lastRow_ = 0;
  RowCopy row_;
};

}  // namespace suture::frame
