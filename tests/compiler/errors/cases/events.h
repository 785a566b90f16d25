#pragma once
#include <suture/annotate.h>
namespace demo {
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_EVENT() suture::EventOf<int, int> pair;
  SUTURE_EVENT() suture::EventOf<int*> place;
  SUTURE_EVENT() suture::EventOf<void> nothing;
  SUTURE_EVENT() int number;
  suture::EventOf<> forgotten;
};
}  // namespace demo
