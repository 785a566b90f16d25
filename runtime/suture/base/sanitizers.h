#pragma once
// This says which sanitizers the including file is compiled with. GCC 12 tells it by macros and
// clang by features. Libraries define `__has_feature` under GCC too, so its presence says nothing.

#ifdef __clang__
#if __has_feature(thread_sanitizer)
#define SUTURE_THREAD_SANITIZER
#endif
#if __has_feature(address_sanitizer)
#define SUTURE_ADDRESS_SANITIZER
#endif
#endif

#ifdef __SANITIZE_THREAD__
#define SUTURE_THREAD_SANITIZER
#endif
#ifdef __SANITIZE_ADDRESS__
#define SUTURE_ADDRESS_SANITIZER
#endif
