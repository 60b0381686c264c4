# `cpack -G DEB`, in the build folder, makes a package for the Debian it was built on; tests/package/deb tries it.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/package_files.cmake)
set(CPACK_PACKAGE_CONTACT "the ropesim authors <ropesim@example.org>")
file(READ cmake/debian/description CPACK_DEBIAN_PACKAGE_DESCRIPTION)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# Loaded at run time, or run: shlibdeps does not see them.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libosmesa6 | libegl1")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "ffmpeg, gnuplot-nox | gnuplot")
include(CPack)
