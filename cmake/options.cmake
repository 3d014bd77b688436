# Compile options that every target of the project shares.
add_library(mpm_options INTERFACE)
target_compile_options(mpm_options INTERFACE -Wall -Wextra)
# GCC 12 sees overlapping or endless copies in every `"text" + std::string` (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(mpm_options INTERFACE -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds)
endif()
if(CMAKE_UNITY_BUILD)
  # Each source is an included file there, whose own types in anonymous namespaces GCC takes for a header's.
  target_compile_options(mpm_options INTERFACE -Wno-subobject-linkage)
endif()
# What waits for others (tests, verbs, the study engine, fits and figures): higher levels only make the build longer, a
# clean one of 550 CPU-seconds by 450. Not for loops over particles.
add_library(mpm_glue_options INTERFACE)
target_link_libraries(mpm_glue_options INTERFACE mpm_options)
target_compile_options(mpm_glue_options INTERFACE $<$<CONFIG:Release,RelWithDebInfo>:-Og>)
# The same bits on every machine that runs the same binary: no contraction and no reassociation unless a
# kernel asks for it.
target_compile_options(mpm_options INTERFACE -ffp-contract=off)
if(MPM_NATIVE)
  target_compile_options(mpm_options INTERFACE -march=native)
endif()
if(MPM_SANITIZE)
  target_compile_options(mpm_options INTERFACE -fsanitize=${MPM_SANITIZE} -fno-sanitize-recover=all
                         -fno-omit-frame-pointer -g1)
  target_link_options(mpm_options INTERFACE -fsanitize=${MPM_SANITIZE})
endif()
