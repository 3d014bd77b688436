# Compile options that every target of the project shares.
add_library(mpm_options INTERFACE)
target_compile_options(mpm_options INTERFACE -Wall -Wextra)
# The same bits on every machine that runs the same binary: no contraction and no reassociation unless a
# kernel asks for it.
target_compile_options(mpm_options INTERFACE -ffp-contract=off)
if(MPM_NATIVE)
  target_compile_options(mpm_options INTERFACE -march=native)
endif()
if(MPM_SANITIZE)
  target_compile_options(mpm_options INTERFACE -fsanitize=${MPM_SANITIZE} -fno-omit-frame-pointer -g)
  target_link_options(mpm_options INTERFACE -fsanitize=${MPM_SANITIZE})
endif()
