#include "watch/watch.suture.h"
