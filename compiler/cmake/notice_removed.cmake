# cmake -DSTAMP=file -DGENERATED=dir -DWIRE=dir -DSTEMS=list -P notice_removed.cmake
#
# Make looks at one output of a command only: where another is gone, that one goes too, and the command runs again.

cmake_minimum_required(VERSION 3.25)
foreach(stem IN LISTS STEMS)
  foreach(ending suture.h suture.cpp suture.json capnp)
    if(STAMP AND NOT EXISTS "${GENERATED}/${stem}.${ending}")
      file(REMOVE "${STAMP}")
    endif()
  endforeach()
  if(NOT EXISTS "${WIRE}/${stem}.capnp.h")
    file(REMOVE "${WIRE}/${stem}.capnp.c++")
  endif()
endforeach()
