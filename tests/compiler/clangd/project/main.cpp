#include "hand.suture.h"

int main() { return 0; }
