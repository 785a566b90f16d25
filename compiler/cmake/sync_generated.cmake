# cmake -DBUILT=dir -DCOMMITTED=dir -DLIST=file [-DUPDATE=ON] -P sync_generated.cmake
#
# Compares what a build generated, the files of the list, with what is committed, left-overs included; with
# UPDATE copies what differs.

cmake_minimum_required(VERSION 3.25)
file(STRINGS ${LIST} files)
set(differences "")

foreach(file IN LISTS files)
  if(NOT EXISTS ${BUILT}/${file})
    message(FATAL_ERROR "${BUILT}/${file} is not there: build first; nothing can be compared.")
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${BUILT}/${file} ${COMMITTED}/${file}
    RESULT_VARIABLE different OUTPUT_QUIET ERROR_QUIET)
  if(different AND UPDATE)
    configure_file(${BUILT}/${file} ${COMMITTED}/${file} COPYONLY)
    message(STATUS "updated ${file}")
  elseif(different)
    string(APPEND differences "\n  ${file} differs")
  endif()
endforeach()

file(GLOB_RECURSE committed RELATIVE ${COMMITTED} ${COMMITTED}/*.suture.* ${COMMITTED}/*.wire.cpp ${COMMITTED}/*.wire.*.cpp)
foreach(file IN LISTS committed)
  if(file IN_LIST files)
    continue()
  endif()
  if(UPDATE)
    # This file stays: another configuration, say one with tests, may still generate it.
    message(STATUS "left alone ${file}: this build generates no such file")
  else()
    string(APPEND differences "\n  ${file} is generated from no header any more")
  endif()
endforeach()

if(differences)
  message(FATAL_ERROR "${COMMITTED} is not what suturec writes:${differences}\n"
    "Run the build target update-generated and commit the result.")
endif()
