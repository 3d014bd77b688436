cmake_minimum_required(VERSION 3.25)
# Writes OUTPUT, a header with the revision of the sources in SOURCE; run at every build, so that a commit is
# seen without configuring again. The file is touched only when the text changes.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude=*
                OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT revision)
  set(revision unknown)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#define MPMSTUDY_GIT_REVISION \"@revision@\"\n" @ONLY)
