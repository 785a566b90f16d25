# cmake -DSUTUREC=program -DRSP=file -DOUTPUTS=list -DWRITTEN=file -P write_missing.cmake
#
# Ends the run of suturec before it: its files are there, unless someone has removed one since.

cmake_minimum_required(VERSION 3.25)
foreach(output IN LISTS OUTPUTS)
  if(NOT EXISTS "${output}")
    execute_process(COMMAND ${SUTUREC} @${RSP} RESULT_VARIABLE failed)
    if(failed)
      message(FATAL_ERROR "${output} is not there, and suturec failed")
    endif()
    break()
  endif()
endforeach()
file(TOUCH "${WRITTEN}")
