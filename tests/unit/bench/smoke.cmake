# cmake -DBENCH=program -DJSON=file -DBOUNDS=file -P smoke.cmake
#
# A short run of table2 ends well and leaves every figure; a bound that no machine can keep makes --check
# fail. This does not judge how fast it was.

file(REMOVE ${JSON})
execute_process(COMMAND ${BENCH} table2 --quick --json ${JSON} RESULT_VARIABLE status OUTPUT_VARIABLE output
  ERROR_VARIABLE errors)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "suture-bench table2 --quick ended with ${status}:\n${output}${errors}")
endif()
file(READ ${JSON} json)

set(loops "")
foreach(policy other fifo)
  foreach(loop scs csc)
    list(APPEND loops ${policy}.${loop}.local ${policy}.${loop}.network)
    list(APPEND values ${policy}.${loop}.difference.mean ${policy}.${loop}.difference.p50)
  endforeach()
endforeach()
foreach(loop scs scs_client csc one_way)
  list(APPEND loops event.${loop}.local event.${loop}.network)
  list(APPEND values event.${loop}.difference event.${loop}.ratio)
endforeach()
list(APPEND loops raw.unix raw.tcp codec.encode codec.create codec.decode codec.sum execution)
foreach(loop scs csc)
  foreach(part preparation transmission execution)
    list(APPEND values overhead.${loop}.${part})
  endforeach()
endforeach()

# SCHED_FIFO may be refused; then the figures say so.
function(require figure members)
  string(JSON reason ERROR_VARIABLE absent GET "${json}" figures ${figure} unavailable)
  if(figure MATCHES "^fifo" AND NOT absent)
    return()
  endif()
  foreach(member IN LISTS members)
    string(JSON value ERROR_VARIABLE absent GET "${json}" figures ${figure} ${member})
    if(absent)
      message(FATAL_ERROR "${figure}: no ${member} in ${JSON}: ${absent}")
    endif()
  endforeach()
endfunction()
foreach(figure IN LISTS loops)
  require(${figure} "unit;count;mean;std;min;p50;p99;p99.9;max")
endforeach()
foreach(figure IN LISTS values)
  require(${figure} "unit;value")
endforeach()

# These runs take the same loops over other lanes, and between two machines as far as the network goes, which takes
# root.
execute_process(COMMAND id -u OUTPUT_VARIABLE user OUTPUT_STRIP_TRAILING_WHITESPACE)
set(ways "--lane frame" "--lane shm" "--lane frame --tcp")
if(user EQUAL 0)
  list(APPEND ways "--namespaces" "--namespaces --lane frame")
endif()
foreach(way IN LISTS ways)
  separate_arguments(arguments UNIX_COMMAND "${way}")
  execute_process(COMMAND ${BENCH} table2 --quick --event-driven-only ${arguments} RESULT_VARIABLE status
    OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT status EQUAL 0 OR NOT output MATCHES "one way +local")
    message(FATAL_ERROR "suture-bench table2 --quick ${way} ended with ${status}:\n${output}${errors}")
  endif()
endforeach()

file(WRITE ${BOUNDS} "table2.codec.sum.p50 <= 0 ns | nothing takes no time\n")
execute_process(COMMAND ${BENCH} table2 --quick --check --bounds ${BOUNDS} RESULT_VARIABLE status
  OUTPUT_VARIABLE output ERROR_VARIABLE errors)
if(NOT status EQUAL 1 OR NOT output MATCHES "falls short: codec.sum.p50")
  message(FATAL_ERROR "a bound of 0 ns was kept, or not reported (exit status ${status}):\n${output}${errors}")
endif()
