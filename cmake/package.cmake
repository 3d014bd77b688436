# `cpack` in a build folder makes mpmstudy_VERSION_ARCHITECTURE.deb: program, library, manual page, completion.
# It has what `cmake --install` installs; tests/setup/deb_test.sh unpacks it into an empty root and tries it.
configure_file(${PROJECT_SOURCE_DIR}/runner/install/mpmstudy.1.in ${PROJECT_BINARY_DIR}/mpmstudy.1 @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/mpmstudy.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_SOURCE_DIR}/runner/install/mpmstudy.bash
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME mpmstudy)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ${PROJECT_NAME})
set(CPACK_PACKAGE_CONTACT "the developers of mpmstudy <mpmstudy@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMPRESSION_TYPE zstd)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # by dpkg-shlibdeps: the shared libraries that the program is linked with
set(CPACK_DEBIAN_PACKAGE_DEPENDS "gnuplot-nox | gnuplot, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev, libhdf5-dev, paraview, sqlite3, slurm-client")
include(CPack)
