# Runs SUTUREC on the headers STEMS of ROOT and compares what it writes with ROOT/expected. SYSTEM, RUNTIME: include
# folders; OUT: scratch.
file(REMOVE_RECURSE ${OUT})
list(TRANSFORM STEMS APPEND .h OUTPUT_VARIABLE headers)
list(TRANSFORM SYSTEM PREPEND -isystem OUTPUT_VARIABLE includes)
execute_process(
  COMMAND ${SUTUREC} --target-name types --base-dir . --out ${OUT} --lock-dir expected ${headers}
          -- -I. -I${RUNTIME} ${includes}
  WORKING_DIRECTORY ${ROOT}
  RESULT_VARIABLE status)
if(status)
  message(FATAL_ERROR "suturec refuses the headers")
endif()
foreach(stem IN LISTS STEMS)
  file(GLOB names RELATIVE ${OUT} ${OUT}/${stem}.suture.* ${OUT}/${stem}.wire.cpp)
  foreach(name IN LISTS names)
    execute_process(COMMAND diff -u ${ROOT}/expected/${name} ${OUT}/${name} RESULT_VARIABLE differs)
    if(differs)
      message(SEND_ERROR "${name} is not what is expected")
    endif()
  endforeach()
endforeach()
