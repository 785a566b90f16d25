# These targets keep what is committed in step with the headers: update-lock, accept-break (the same, where old peers no longer count),
# update-generated, and the test check-generated. Each serves all suture_generate() calls of a project, so they are defined when the
# project's own list file ends.

function(suture_register_upkeep suturec target stems entry)
  set_property(GLOBAL APPEND PROPERTY SUTURE_UPKEEP_TARGETS ${target})
  set_property(GLOBAL PROPERTY SUTURE_UPKEEP_COMPILER ${suturec})
  set_property(GLOBAL PROPERTY SUTURE_UPKEEP_RSP_${target}
    ${CMAKE_CURRENT_BINARY_DIR}/${target}.suture.rsp)
  suture_outputs(files "${stems}" include compile read)
  set_property(GLOBAL APPEND PROPERTY SUTURE_UPKEEP_FILES ${entry} ${files})
  get_property(deferred GLOBAL PROPERTY SUTURE_UPKEEP_DEFERRED)
  if(NOT deferred)
    set_property(GLOBAL PROPERTY SUTURE_UPKEEP_DEFERRED TRUE)
    cmake_language(DEFER DIRECTORY ${PROJECT_SOURCE_DIR} CALL suture_define_upkeep)
  endif()
endfunction()

function(suture_define_upkeep)
  get_property(targets GLOBAL PROPERTY SUTURE_UPKEEP_TARGETS)
  get_property(suturec GLOBAL PROPERTY SUTURE_UPKEEP_COMPILER)
  get_property(files GLOBAL PROPERTY SUTURE_UPKEEP_FILES)
  foreach(target IN LISTS targets)
    get_property(rsp GLOBAL PROPERTY SUTURE_UPKEEP_RSP_${target})
    list(APPEND update_lock COMMAND ${suturec} @${rsp} --update-lock)
    list(APPEND accept_break COMMAND ${suturec} @${rsp} --update-lock --accept-break)
    list(APPEND stamps ${target}_suture)
  endforeach()
  add_custom_target(update-lock ${update_lock} VERBATIM COMMENT "Updating the locked schemas")
  add_custom_target(accept-break ${accept_break} VERBATIM COMMENT "Updating the locked schemas, breaks included")

  set(list ${CMAKE_BINARY_DIR}/generated.list)
  list(JOIN files "\n" text)
  file(GENERATE OUTPUT ${list} CONTENT "${text}\n")
  set(script ${CMAKE_COMMAND} -DBUILT=${CMAKE_BINARY_DIR}/generated
    -DCOMMITTED=${PROJECT_SOURCE_DIR}/generated -DLIST=${list})
  set(path ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/sync_generated.cmake)
  add_custom_target(update-generated COMMAND ${script} -DUPDATE=ON -P ${path}
    VERBATIM COMMENT "Updating generated/")
  add_dependencies(update-generated ${stamps})
  add_test(NAME check-generated COMMAND ${script} -P ${path})
endfunction()
