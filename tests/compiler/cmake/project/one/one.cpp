#include "one/client.suture.h"
#include "one/provider.suture.h"
