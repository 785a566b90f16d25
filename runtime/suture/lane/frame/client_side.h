#pragma once
// The client's side of a frame connection: the provider endpoint of a channel.

#include <suture/lane/frame/connection.h>

#include <array>
#include <cstdint>
#include <vector>

namespace suture::frame {

/// Sends what the client has put into its channel, and puts there what the provider's side sends.
/// Belongs to the lane thread.
class ClientSide final : public Connection {
 public:
  /// `channel`'s state table is a mirror that this writes; its provider doorbell is the lane
  /// thread's.
  ClientSide(std::shared_ptr<Channel> channel, std::unique_ptr<Payloads> payloads,
             std::uint32_t number);

 private:
  bool take(const Header& header, std::span<std::byte> payload) override;
  void takePart(Kind kind, std::span<const std::byte> payload) override;
  void taken() override;
  bool give() override;
  void letGo(Kind kind) override;

  bool takeReply(const Header& header, std::span<std::byte> payload);
  bool takeEvent(const Header& header, std::span<std::byte> payload);
  bool takeRow(const Header& header, std::span<std::byte> payload);
  bool takeCredits(const Header& header);
  bool takeTally(std::span<const std::byte> payload);

  void giveSubscription();
  void giveCommands();
  void giveCommand(const rt::CommandRecord& record);

  EventSet events_ = 0;  // that the provider's side has been told of
  rt::ColumnSet columns_ = 0;
  std::uint32_t subscription_ = 0;    // how many have been sent
  std::vector<std::uint32_t> since_;  // by event: the subscription that began it
  struct Sent {
    std::uint32_t call = 0;
    std::uint16_t command = 0;
  };
  std::array<Sent, Channel::kMaxCalls> calls_;  // by number
  std::vector<std::uint32_t> lent_;             // by command: how many use a credit
  bool arrival_ = false, news_ = false;         // the client is to be rung for
};

}  // namespace suture::frame
