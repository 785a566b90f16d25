#include <suture/cli/answer_text.h>
#include <suture/cli/arguments.h>
#include <suture/cli/screen.h>
#include <suture/cli/verbs.h>

namespace suture::cli {

int call(rpc::EventPort& loop, const Options& options) {
  const Json arguments = argumentsOf(options);
  Provider provider(loop, options, Target::parseInterface(options.target));
  const Member& command = provider.contract().command(options.member);
  if (options.json) {
    printJson(answerJson(command, provider.call(command, arguments, Labels::Names)));
  } else {
    print(answerText(provider.call(command, arguments, Labels::Units)));
  }
  return 0;
}

}  // namespace suture::cli
