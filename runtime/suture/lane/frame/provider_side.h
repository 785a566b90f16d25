#pragma once
// This is the provider's side of a frame connection: the client's end of a channel.

#include <suture/lane/carrier/provider_carrier.h>
#include <suture/lane/frame/connection.h>
#include <suture/lane/frame/payloads/row_copy.h>

#include <array>
#include <cstdint>
#include <vector>

namespace suture::frame {

/// Says what a client calls the commands, by the number that it gives each of them.
struct ClientCommands {
  /// Each entry is the number here, or ProviderSide::kUnknown; the list is empty if the two have
  /// the same numbers.
  std::vector<std::uint16_t> numbers;
  /// Tells if the client's contract says latest(); for those beyond its end, the provider's does.
  std::vector<bool> latest;
};

/// Belongs to the lane thread. Puts the commands that arrive into the provider's channel, and sends
/// what the provider answers, emits and publishes.
class ProviderSide final : public Connection, private ProviderCarrier::Wire {
 public:
  /// Stands for a command that the contract does not have.
  static constexpr std::uint16_t kUnknown = ProviderCarrier::kUnknown;

  /// `channel`'s client doorbell is the lane thread's.
  ProviderSide(std::shared_ptr<Channel> channel, std::unique_ptr<Payloads> payloads,
               std::uint32_t number, ClientCommands commands = {});

  /// Before it is carried: accepts only reads from now on; a command is refused
  /// (Errc::NotPermitted).
  void setReadOnly() { carrier_.setReadOnly(); }

 private:
  using Message = ProviderCarrier::Message;

  bool take(const Header& header, std::span<std::byte> payload) override;
  void taken() override { carrier_.ringProvider(); }
  bool give() override;
  void letGo(Kind kind) override;

  bool takeCommand(const Header& header, std::span<std::byte> payload);
  bool hasUsedCredit(const Header& header) const;
  bool tellRefused(const Header& header, Errc error);
  bool takeSubscription(const Header& header, std::span<const std::byte> payload);

  bool hasRoom(Message) const override { return Connection::hasRoom(); }
  void send(const ReplyRecord& reply) override;
  void sendCredits(std::uint16_t command, std::uint32_t count) override;
  void send(const Tally& tally) override;
  void send(const rt::EventRecord& event, std::uint32_t subscription) override;
  bool sendRow(rt::ColumnSet columns, std::uint64_t& last) override;
  void sendRefusals();

  bool heard_ = false;  // the client's side has been heard, so it exists
  struct RefusedCall {
    std::uint32_t call;
    Errc error;
  };
  std::array<RefusedCall, Channel::kMaxCalls> refusedCalls_;  // those that the client does not know
                                                              // of yet
  std::size_t refusedCallCount_ = 0;
  const std::vector<bool> latest_;  // by the client's number, as its contract says
  RowCopy row_;
  ProviderCarrier carrier_;
};

}  // namespace suture::frame
