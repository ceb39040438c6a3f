# An object compiled for an instruction set defines one global symbol, its table, and no weak one (an inline function or
# template) that the linker could keep for all other objects.
cmake_minimum_required(VERSION 3.25)
foreach(object ${OBJECTS})
  execute_process(COMMAND ${NM} --defined-only --extern-only --format=posix ${object} OUTPUT_VARIABLE listing COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]+" symbols "${listing}")
  list(LENGTH symbols count)
  if(NOT count EQUAL 1)
    message(SEND_ERROR "${object} defines ${count} global symbols:\n${listing}")
  elseif(listing MATCHES "^[^ ]+ [WVu]")
    message(SEND_ERROR "${object} defines a weak symbol: ${listing}")
  endif()
endforeach()
