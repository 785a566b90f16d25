#include <suture/framing/unfinished_answers.h>

namespace suture::framing {

using Message = capnp::rpc::Message;

std::string_view UnfinishedAnswers::arrived(Message::Reader message, const Limits& limits) {
  std::uint32_t question = 0;
  switch (message.which()) {
    case Message::FINISH: finish(message.getFinish().getQuestionId()); return "";
    case Message::BOOTSTRAP: question = message.getBootstrap().getQuestionId(); break;
    case Message::CALL: question = message.getCall().getQuestionId(); break;
    default: return "";
  }
  if (question >= limits.questions) return "the peer asks more at a time than it may";
  if (bytes_ > limits.bytes) return "the peer keeps more answers than it may";
  begin(question);
  return "";
}

void UnfinishedAnswers::sent(Message::Reader message, std::size_t bytes) {
  if (!message.isReturn()) return;
  const std::uint32_t question = message.getReturn().getAnswerId();
  if (question >= answers_.size() || answers_[question].isFinished) return;
  answers_[question].bytes += bytes;
  bytes_ += bytes;
}

void UnfinishedAnswers::begin(std::uint32_t question) {
  finish(question);  // its number may be in use, which Cap'n Proto judges
  if (question >= answers_.size()) answers_.resize(question + 1);
  answers_[question] = {};
}

void UnfinishedAnswers::finish(std::uint32_t question) {
  if (question >= answers_.size()) return;
  bytes_ -= answers_[question].bytes;
  answers_[question] = {.bytes = 0, .isFinished = true};
}

}  // namespace suture::framing
