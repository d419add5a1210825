# Writes a C++ source with a function that gives the text of each file by its name without ending; empty of any other.
# What a file includes (`#include "other"`, beside it) stands in its place.
#
# cmake -DFILES=<path,path,...> -DHEADER=<that declares it> -DFUNCTION=<its full name> -DOUT=<file> -P embed.cmake
string(REPLACE "," ";" files "${FILES}")
set(text "// Made by deploy/cmake/embed.cmake.\n#include \"${HEADER}\"\n\n")
string(APPEND text "std::string_view ${FUNCTION}(std::string_view name) {\n")
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME_WE)
  get_filename_component(folder ${file} DIRECTORY)
  file(READ ${file} own)
  string(REGEX MATCHALL "#include \"[^\"\n]*\"\n" includes "${own}")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "#include \"(.*)\"\n" "\\1" other "${include}")
    file(READ ${folder}/${other} inside)
    string(REPLACE "${include}" "${inside}" own "${own}")
  endforeach()
  string(APPEND text "  if (name == \"${name}\") return R\"embedded(${own})embedded\";\n")
endforeach()
file(WRITE ${OUT} "${text}  return {};\n}\n")
