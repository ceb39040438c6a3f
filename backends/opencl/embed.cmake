# Writes OUTPUT, a C++ file that defines weft::opencl::program_source: the texts of SOURCES, each a string, of which
# together the program consists.
#   cmake -D OUTPUT=... -D "SOURCES=a;b" -P embed.cmake
# A device compiler has no path to our headers: lines that include them are left out, and SOURCES come in their order.
set(texts "R\"weft(#pragma OPENCL FP_CONTRACT OFF\n)weft\"")
set(count 1)
foreach(source IN LISTS SOURCES)
  file(READ ${source} part)
  string(REGEX REPLACE "#[ \t]*include[ \t]*\"[^\n]*\n" "\n" part "${part}")
  string(FIND "${part}" ")weft\"" end)
  if(NOT end EQUAL -1)
    message(FATAL_ERROR "${source} holds the end mark of the literal that it becomes")
  endif()
  string(APPEND texts ",\nR\"weft(${part})weft\"")
  math(EXPR count "${count} + 1")
endforeach()
file(WRITE ${OUTPUT}
  "/// Made by embed.cmake: the OpenCL program.\nnamespace weft::opencl {\n"
  "extern const unsigned program_parts;\nextern const char* program_source[];\n"
  "const unsigned program_parts = ${count};\n"
  "const char* program_source[] = {${texts}};\n} // namespace weft::opencl\n")
