# cmake -DSTAMP=file -DGENERATED=dir -DWIRE=dir -DSTEMS=list -DPARTS=list -DOUTPUTS=list -P notice_removed.cmake
#
# Make looks at one output of a command only: where another is gone, that one goes too, and the command runs again.

cmake_minimum_required(VERSION 3.25)
foreach(output IN LISTS OUTPUTS)
  if(STAMP AND NOT EXISTS "${GENERATED}/${output}")
    file(REMOVE "${STAMP}")
  endif()
endforeach()
foreach(part IN LISTS PARTS)
  if(NOT EXISTS "${WIRE}/${part}.h" OR NOT EXISTS "${WIRE}/${part}.c++")
    string(REGEX REPLACE "\\.wire(\\.[0-9]+)?\\.capnp$" "" stem ${part})
    file(REMOVE "${WIRE}/${stem}.capnp.h")
  endif()
endforeach()
foreach(stem IN LISTS STEMS)
  if(NOT EXISTS "${WIRE}/${stem}.capnp.h")
    file(REMOVE "${WIRE}/${stem}.capnp.c++")
  endif()
endforeach()
