#include <suture/base/field_path.h>
#include <suture/component/provided/command_runner.h>
#include <suture/component/provided/interface_clients.h>

namespace suture {

Errc produce(CommandRunner& runner, InterfaceClients& clients, std::uint16_t command,
             const std::byte* arguments, std::byte* result, Channel* asker) {
  const Errc error = runner.execute(command, arguments, result);
  FieldPath path;
  if (error != Errc{} || clients.info().commands[command].admitsResult(result, &path)) return error;
  clients.noteInvalid(path, asker);
  return Errc::Invalid;
}

}  // namespace suture
