# Writes OUTPUT, a C++ file that defines weft::opencl::program_source: the texts of SOURCES as one string.
#   cmake -D OUTPUT=... -D "SOURCES=a;b" -P embed.cmake
# A device compiler has no path to our headers: lines that include them are left out, and SOURCES come in their order.
set(text "#pragma OPENCL FP_CONTRACT OFF\n")
foreach(source IN LISTS SOURCES)
  file(READ ${source} part)
  string(REGEX REPLACE "#[ \t]*include[ \t]*\"[^\n]*\n" "\n" part "${part}")
  string(APPEND text "${part}")
endforeach()
string(FIND "${text}" ")weft\"" end)
if(NOT end EQUAL -1)
  message(FATAL_ERROR "the OpenCL source holds the end mark of the literal that it becomes")
endif()
file(WRITE ${OUTPUT}
  "/// Made by embed.cmake: the OpenCL program.\nnamespace weft::opencl {\nextern const char program_source[];\n"
  "const char program_source[] = R\"weft(${text})weft\";\n} // namespace weft::opencl\n")
