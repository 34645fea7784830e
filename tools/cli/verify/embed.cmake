# Writes OUTPUT: the references of FOLDER (NAME.toml with NAME.csv) as string literals.
file(GLOB profiles ${FOLDER}/*.toml)
list(SORT profiles)
set(entries "")
foreach(profile ${profiles})
  cmake_path(GET profile STEM name)
  file(READ ${profile} profile_text)
  file(READ ${FOLDER}/${name}.csv table_text)
  string(APPEND entries "    {\"${name}\", R\"~~(${profile_text})~~\", R\"~~(${table_text})~~\"},\n")
endforeach()
file(
  WRITE ${OUTPUT}
  "#include \"verify/reference.hpp\"\n\nnamespace higherpair::cli {\n\n"
  "std::span<const Reference> shipped_references() {\n  static constexpr Reference kReferences[] = {\n"
  "${entries}  };\n  return kReferences;\n}\n\n}  // namespace higherpair::cli\n")
