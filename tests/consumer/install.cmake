# Installs into one folder, checks what is there, and moves it to another.
cmake_minimum_required(VERSION 3.25)
set(first ${BINARY}/first)
file(REMOVE_RECURSE ${first} ${STAGE})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${first} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
foreach(file include/weft/weft.h include/weft/backend.h include/weft/field.h
    ${LIBDIR}/libweft.so ${LIBDIR}/libweft.so.${MAJOR} ${LIBDIR}/libweft.a
    ${LIBDIR}/weft-${MAJOR}/weft_backend_simd.so ${LIBDIR}/pkgconfig/weft.pc ${LIBDIR}/cmake/weft/weftConfig.cmake
    ${LIBDIR}/cmake/weft/weftConfigVersion.cmake bin/weft share/doc/weft/LICENSE share/doc/weft/README.md share/doc/weft/PROGRAMS.md)
  if(NOT EXISTS ${first}/${file})
    message(SEND_ERROR "${file} was not installed")
  endif()
endforeach()
file(GLOB_RECURSE texts ${first}/*.cmake ${first}/*.pc)
foreach(text ${texts})
  file(READ ${text} content)
  foreach(path ${first} ${TREE} ${BUILD} /usr/lib)
    string(FIND "${content}" "${path}" at)
    if(NOT at EQUAL -1)
      message(SEND_ERROR "${text} holds the path ${path}")
    endif()
  endforeach()
endforeach()
file(RENAME ${first} ${STAGE})
