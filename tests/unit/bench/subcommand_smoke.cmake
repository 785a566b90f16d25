# cmake -DBENCH=program -DSUBCOMMAND=name -DJSON=file -DBOUNDS=file -DPLANTED=figure "-DFIGURES=a;b" -P
# subcommand_smoke.cmake
#
# A short run ends well and leaves every figure; a bound that no machine can keep makes --check fail. This does not
# judge how fast it was.

file(REMOVE ${JSON})
file(WRITE ${BOUNDS} "${SUBCOMMAND}.${PLANTED} <= 0 ns | nothing takes no time\n")
execute_process(COMMAND ${BENCH} ${SUBCOMMAND} --quick --check --bounds ${BOUNDS} --json ${JSON} RESULT_VARIABLE status
  OUTPUT_VARIABLE output ERROR_VARIABLE errors)
if(NOT status EQUAL 1 OR NOT output MATCHES "falls short: ${PLANTED}")
  message(FATAL_ERROR "a bound of 0 ns was kept, or not reported (exit status ${status}):\n${output}${errors}")
endif()
file(READ ${JSON} json)
foreach(figure IN LISTS FIGURES)
  string(JSON unit ERROR_VARIABLE absent GET "${json}" figures ${figure} unit)
  string(JSON reason ERROR_VARIABLE measured GET "${json}" figures ${figure} unavailable)
  if(absent AND measured)
    message(FATAL_ERROR "${figure} is neither in ${JSON} nor said to be unavailable")
  endif()
endforeach()
