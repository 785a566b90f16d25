#include "cli/command_line/arguments.h"
#include "cli/text/answer_text.h"
#include "cli/text/screen.h"
#include "cli/verbs.h"

namespace suture::cli {

int call(rpc::EventPort& loop, const Options& options) {
  const Json arguments = argumentsOf(options);
  Provider provider(loop, options, Target::parseInterface(options.target));
  const Member& command = provider.contract().command(options.member);
  if (options.json) {
    printJson(answerJson(command, provider.call(command, arguments, Labels::Names)));
  } else {
    print(answerText(command, provider.call(command, arguments, Labels::Units)));
  }
  return 0;
}

}  // namespace suture::cli
