# Writes a C++ source that holds, for each sample of the bus, its IDL with what it includes as one text.
#
# cmake -DMESSAGES=<folder of idl/msg> -DSAMPLES=<name,name,...> -DOUT=<file> -P embed.cmake
string(REPLACE "," ";" samples "${SAMPLES}")
file(READ ${MESSAGES}/common.idl common)
set(text "// Made by groundstation/schema/embed.cmake from idl/msg.\n#include \"groundstation/schema/texts.hpp\"\n\n")
string(APPEND text "namespace skein::schema {\n\nstd::string_view idl_text(std::string_view sample) {\n")
foreach(sample IN LISTS samples)
  file(READ ${MESSAGES}/${sample}.idl own)
  string(REPLACE "#include \"common.idl\"\n" "" own "${own}")
  string(FIND "${own}" "#include" other)
  if(NOT other EQUAL -1)
    message(FATAL_ERROR "${sample}.idl includes what embed.cmake does not resolve")
  endif()
  string(APPEND text "  if (sample == \"${sample}\") return R\"idl(${common}\n${own})idl\";\n")
endforeach()
string(APPEND text "  return {};\n}\n\n}  // namespace skein::schema\n")
file(WRITE ${OUT} "${text}")
