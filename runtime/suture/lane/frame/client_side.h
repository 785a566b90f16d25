#pragma once
// This is the client's side of a frame connection: the provider's end of a channel.

#include <suture/lane/carrier/client_carrier.h>
#include <suture/lane/frame/connection.h>

#include <cstdint>

namespace suture::frame {

/// Belongs to the lane thread. Sends what the client has put into its channel, and puts there what
/// the provider's side sends.
class ClientSide final : public Connection, private ClientCarrier::Wire {
 public:
  /// `channel`'s state table is a mirror that this writes; its provider doorbell is the lane
  /// thread's.
  ClientSide(std::shared_ptr<Channel> channel, std::unique_ptr<Payloads> payloads,
             std::uint32_t number);

 private:
  bool take(const Header& header, std::span<std::byte> payload) override;
  void takePart(Kind kind, std::span<std::byte> payload) override;
  void taken() override { carrier_.ringClient(); }
  bool give() override;
  void letGo(Kind) override { carrier_.commandSent(); }

  bool hasRoom(ClientCarrier::Message) const override { return Connection::hasRoom(); }
  void send(const Interest& interest) override;
  void send(const rt::CommandRecord& command) override;

  bool takeReply(const Header& header, std::span<std::byte> payload);
  bool takeEvent(const Header& header, std::span<std::byte> payload);
  bool takeRow(const Header& header, std::span<std::byte> payload);
  bool takeTally(std::span<const std::byte> payload);

  ClientCarrier carrier_;
};

}  // namespace suture::frame
