# Finds LLVM 19.1 with clang's shared library. Sets SUTURE_CLANG_FOUND, SUTURE_CLANG_INCLUDES,
# SUTURE_CLANG_DEFINITIONS, SUTURE_CLANG_LIBRARIES and SUTURE_CLANG_RESOURCE_DIR.
#
# find_package(Clang) is left alone on purpose: with another LLVM installed it takes that one's clang
# without a word. libclang-cpp is looked up beside the LLVM that was found and nowhere else, by its
# versioned name, since the plain link is in a package of its own.

set(SUTURE_CLANG_FOUND FALSE)
if(SUTURE_BUILD_COMPILER STREQUAL "OFF")
  return()
endif()

# The version file wants the exact minor: plain 19 is refused by 19.1.7.
find_package(LLVM 19.1 CONFIG QUIET PATHS /usr/lib/llvm-19/lib/cmake/llvm)
if(LLVM_FOUND)
  find_library(SUTURE_CLANG_CPP NAMES libclang-cpp.so.${LLVM_VERSION_MAJOR}.${LLVM_VERSION_MINOR}
    PATHS ${LLVM_LIBRARY_DIRS} NO_DEFAULT_PATH)
  find_file(SUTURE_CLANG_HEADER clang/Frontend/CompilerInstance.h
    PATHS ${LLVM_INCLUDE_DIRS} NO_DEFAULT_PATH)
  find_path(SUTURE_CLANG_RESOURCE_DIR include/stddef.h
    PATHS ${LLVM_LIBRARY_DIRS}/clang/${LLVM_VERSION_MAJOR} NO_DEFAULT_PATH)
  if(SUTURE_CLANG_CPP AND SUTURE_CLANG_HEADER AND SUTURE_CLANG_RESOURCE_DIR AND TARGET LLVM)
    set(SUTURE_CLANG_FOUND TRUE)
  endif()
endif()

if(NOT SUTURE_CLANG_FOUND)
  set(SUTURE_CLANG_ADVICE "suturec needs LLVM 19.1 with clang's shared library; on Debian and Ubuntu:\n\
  apt-get install libclang-19-dev llvm-19-dev clang-19")
  if(SUTURE_BUILD_COMPILER STREQUAL "ON")
    message(FATAL_ERROR "SUTURE_BUILD_COMPILER is ON but LLVM 19.1 was not found. ${SUTURE_CLANG_ADVICE}\n\
Or set SUTURE_BUILD_COMPILER to AUTO: what is committed in generated/ is compiled instead.")
  endif()
  message(STATUS "Without suturec: compiling generated/. ${SUTURE_CLANG_ADVICE}")
  return()
endif()

message(STATUS "suturec: LLVM ${LLVM_PACKAGE_VERSION}")
separate_arguments(SUTURE_CLANG_DEFINITIONS NATIVE_COMMAND "${LLVM_DEFINITIONS}")
set(SUTURE_CLANG_INCLUDES ${LLVM_INCLUDE_DIRS})
set(SUTURE_CLANG_LIBRARIES ${SUTURE_CLANG_CPP} LLVM)
