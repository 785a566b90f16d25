# cmake -DSUTUREC=program -DRSP=file -DOUTPUTS=list -DWRITTEN=file -P write_missing.cmake
#
# This runs suturec again if someone has removed one of its files since it ran.

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
