#include <suture/loop/deadline.h>
#include <suture/session/client/sessions.h>

#include <algorithm>
#include <utility>

namespace suture {
// Another caller may have begun the attempt with less patience, so its failure is not this one's.
kj::Promise<std::shared_ptr<PeerSession>> Sessions::open(const std::string& process,
                                                         Duration patience, Duration limit) {
  const Time until = fromNow(patience);
  Known& known = known_[process];
  auto opened = known.session.get([&] {
    known.until = until;
    return dial(process, patience, limit);
  });
  return asking_.wrap(
      opened.catch_([this, &known, process, until,
                     limit](kj::Exception&& failure) -> kj::Promise<std::shared_ptr<PeerSession>> {
        const Duration left = until - now();
        if (known.until >= until || left <= Duration{0}) return kj::mv(failure);
        return open(process, left, limit);
      }));
}

bool Sessions::any() const {
  return std::ranges::any_of(known_, [](const auto& one) { return one.second.session.begun(); });
}

kj::Promise<std::shared_ptr<PeerSession>> Sessions::dial(const std::string& process,
                                                         Duration patience, Duration limit) {
  using Opened = std::shared_ptr<PeerSession>;
  return manager_.resolve(process, patience)
      .then(
          [this, process, limit](const ProcessRecord& record) -> kj::Promise<Opened> {
            const auto inTime = [this, process, limit](kj::Promise<void> answer) {
              return loop::within(control_.timer(), limit, kj::mv(answer), noAnswerOf(process));
            };
            return manager_.reach(record, std::min(limit, kDialLimit))
                .then([this, record, inTime](net::ByteStream bytes) {
                  auto session = std::make_shared<PeerSession>(control_, manager_, lanes_, record,
                                                               kj::mv(bytes));
                  return inTime(session->greet(self_))
                      .then([session, inTime] { return inTime(session->compareClocks()); })
                      .then([session] { return session; });
                });
          },
          [](kj::Exception&& notThere) -> kj::Promise<Opened> {
            return loop::disconnected(loop::describe(notThere));  // it may come
          });
}

std::string noAnswerOf(const std::string& process) {
  return "talk to process '" + process +
         "': it is there, but does not answer. It hangs, has no file descriptor left for another "
         "link, or has not yet made its components known: see what it says and does.";
}

}  // namespace suture
