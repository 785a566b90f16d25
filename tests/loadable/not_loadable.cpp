// This is a shared library that has nothing to do with Suture.
extern "C" int answer() { return 42; }
