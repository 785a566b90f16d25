#include "cli/text/answer_text.h"
#include "cli/text/screen.h"
#include "cli/verbs.h"

namespace suture::cli {

int read(loop::EventPort& loop, const Options& options) {
  Provider provider(loop, options, Target::parseInterface(options.target));
  const Member& command = readCommand(provider.contract(), options.member);
  if (options.json) {
    printJson(answerJson(command, provider.call(command, Json::object(), codec::Labels::Names)));
  } else {
    print(answerText(command, provider.call(command, Json::object(), codec::Labels::Units)));
  }
  return 0;
}

}  // namespace suture::cli
