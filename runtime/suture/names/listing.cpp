#include <suture/names/listing.h>

#include <utility>

namespace suture {
namespace {

kj::Promise<std::vector<ProcessRecord>> listBehind(wire::Session::Client session,
                                                   std::vector<ProcessRecord> before) {
  auto request = session.listRequest();
  if (!before.empty()) request.setAfter(codec::textOf(before.back().name));
  return request.send().then(
      [session,
       all = std::move(before)](auto&& results) mutable -> kj::Promise<std::vector<ProcessRecord>> {
        const auto page = results.getProcesses();
        for (const auto process : page) all.push_back(fromWire(process));
        if (!results.getMore() || page.size() == 0) return std::move(all);
        return listBehind(session, std::move(all));
      });
}

}  // namespace

kj::Promise<std::vector<ProcessRecord>> listAll(wire::Session::Client session) {
  return listBehind(kj::mv(session), {});
}

}  // namespace suture
