#include "count/counter.suture.h"
