#pragma once
// Says which sanitizers the including file is compiled with: GCC 12 and clang tell it differently.

#ifdef __has_feature
#if __has_feature(thread_sanitizer)
#define SUTURE_THREAD_SANITIZER
#endif
#if __has_feature(address_sanitizer)
#define SUTURE_ADDRESS_SANITIZER
#endif
#else
#ifdef __SANITIZE_THREAD__
#define SUTURE_THREAD_SANITIZER
#endif
#ifdef __SANITIZE_ADDRESS__
#define SUTURE_ADDRESS_SANITIZER
#endif
#endif
