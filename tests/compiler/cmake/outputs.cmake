# The copy LIST must be what SUTUREC --list-outputs prints.
execute_process(COMMAND ${SUTUREC} --list-outputs OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ ${LIST} listed)
if(NOT printed STREQUAL listed)
  message(FATAL_ERROR "${LIST} is not what suturec --list-outputs prints; write there:\n${printed}")
endif()
