#pragma once
// The parts of a provided interface run its commands by this.

#include <suture/base/errors.h>

#include <cstddef>
#include <cstdint>

namespace suture {

class Channel;
class InterfaceClients;

/// Runs the commands of a contract on its implementation. Belongs to the thread that serves the
/// interface.
class CommandRunner {
 public:
  CommandRunner() = default;
  CommandRunner(const CommandRunner&) = delete;
  CommandRunner& operator=(const CommandRunner&) = delete;

  /// Runs command `command` on its arguments' slot, and fills `result` if the command has one.
  /// suturec writes it. Returns 0 or Errc::TooLarge.
  virtual Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) = 0;

 protected:
  ~CommandRunner() = default;
};

/// Executes a command of `clients`, and answers Errc::Invalid for a result that the contract does
/// not admit. `asker` is the client that does not get it; null means all clients.
Errc produce(CommandRunner& runner, InterfaceClients& clients, std::uint16_t command,
             const std::byte* arguments, std::byte* result, Channel* asker);

}  // namespace suture
