# cmake -DBENCH=program -DJSON=file -DBOUNDS=file -P local_smoke.cmake
#
# A short run of `local` ends well and leaves every figure that has a bound; a bound that nothing can keep makes --check
# fail. How fast it was is not judged here.

file(REMOVE ${JSON})
file(WRITE ${BOUNDS} "local.ring.p50 <= 0 ns | nothing takes no time\n")
execute_process(COMMAND ${BENCH} local --quick --check --bounds ${BOUNDS} --json ${JSON} RESULT_VARIABLE status
  OUTPUT_VARIABLE output ERROR_VARIABLE errors)
if(NOT status EQUAL 1 OR NOT output MATCHES "falls short: ring.p50")
  message(FATAL_ERROR "a bound of 0 ns was kept, or not reported (exit status ${status}):\n${output}${errors}")
endif()
file(READ ${JSON} json)
foreach(figure ring state_read state_read.whole read_command csc bare csc.ratio fan_out throughput
    throughput.two_processors jitter.task.p50 jitter.task.p99 jitter.task.max jitter.bare.p50 jitter.bare.p99
    jitter.bare.max)
  string(JSON unit ERROR_VARIABLE absent GET "${json}" figures ${figure} unit)
  string(JSON reason ERROR_VARIABLE measured GET "${json}" figures ${figure} unavailable)
  if(absent AND measured)
    message(FATAL_ERROR "${figure} is neither in ${JSON} nor said to be unavailable")
  endif()
endforeach()
