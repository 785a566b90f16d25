#include "parts/ruler.suture.h"
