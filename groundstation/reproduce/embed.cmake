# Writes a C++ source that holds scenarios as texts, so that an installed program needs no file.
#
# cmake -DFOLDER=<deploy/scenarios> -DSCENARIOS=<name,name,...> -DOUT=<file> -P embed.cmake
string(REPLACE "," ";" scenarios "${SCENARIOS}")
set(text "// Made by groundstation/reproduce/embed.cmake from deploy/scenarios.\n")
string(APPEND text "#include \"groundstation/reproduce/scenarios.hpp\"\n\nnamespace skein::reproduce {\n\n")
string(APPEND text "std::string_view scenario_text(std::string_view name) {\n")
foreach(name IN LISTS scenarios)
  file(READ ${FOLDER}/${name}.yaml own)
  string(APPEND text "  if (name == \"${name}\") return R\"yaml(${own})yaml\";\n")
endforeach()
string(APPEND text "  return {};\n}\n\n}  // namespace skein::reproduce\n")
file(WRITE ${OUT} "${text}")
