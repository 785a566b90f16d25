#include <suture/base/field_path.h>
#include <suture/component/provided/command_runner.h>
#include <suture/component/provided/interface_clients.h>

namespace suture {

Errc CommandRunner::produce(std::uint16_t command, const std::byte* arguments, std::byte* result,
                            Channel* asker) {
  const Errc error = execute(command, arguments, result);
  FieldPath path;
  if (error != Errc{} || clients_.info().commands[command].admitsResult(result, &path))
    return error;
  clients_.noteInvalid(path, asker);
  return Errc::Invalid;
}

}  // namespace suture
