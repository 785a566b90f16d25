#pragma once
// The first version's processes do this.

#include <suture/component/task/event_task.h>

#include <iostream>

#include "tests/compiler/evolution/values.h"

namespace evolution {

class Feeder final : public suture::EventTask, public Feed {
 public:
  ~Feeder() override { stop(); }

  void put(const Sample& sample, double speed) override {
    std::cout << "got label='" << sample.label << "'";
    print(sample, std::cout);
    std::cout << " speed=" << speed << std::endl;
    feed_.emit().moved(sample);
  }
  Mode mode() const override { return Mode::On; }

 private:
  void run() override {}

  suture::Provided<Feed> feed_{*this, "Feed", *this};
};

inline auto startPut(suture::Required<Feed>& feed) { return feed.put.start(example(), 0.5); }

/// Does nothing, since only a later version can ask this.
inline void tryNewest(suture::Required<Feed>&) {}

}  // namespace evolution
