# `cpack` makes two Debian packages: boxbeam, the program, and libboxbeam-dev, the library.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME boxbeam)
set(CPACK_PACKAGE_CONTACT "The boxbeam maintainers <boxbeam@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME boxbeam)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS
  "gnuplot-nox | gnuplot, texlive-latex-base, texlive-latex-recommended, lmodern")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
  "strength and fatigue verification of moving welded beams
 From a case file that describes a mechanism, a welded beam that it moves and
 what is demanded of it, boxbeam finds motion, loads, cut forces and stresses
 and checks strength and fatigue life. It writes a report as text, HTML, PDF
 and JSON.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libboxbeam-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libeigen3-dev, libboost-dev, libboost-iostreams-dev, libboost-filesystem-dev, libfmt-dev, \
libtomlplusplus-dev, libmd-dev, libmuparser-dev, libnlopt-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "library of boxbeam, verification of moving welded beams
 Headers, static library and CMake package (find_package(boxbeam)) for
 programs that verify welded beams moved by a mechanism.")

# What Debian's policy wants in every package.
string(TIMESTAMP stamp "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(name IN ITEMS boxbeam libboxbeam-dev)
  string(TOLOWER ${name} folder)
  set(documents ${CMAKE_BINARY_DIR}/debian/${folder})
  set(BOXBEAM_PACKAGE ${name})
  configure_file(cmake/debian/changelog.in ${documents}/changelog @ONLY)
  execute_process(COMMAND ${GZIP} -9nf ${documents}/changelog COMMAND_ERROR_IS_FATAL ANY)
  if(name STREQUAL boxbeam)
    set(part program)
  else()
    set(part development)
  endif()
  install(FILES ${documents}/changelog.gz cmake/debian/copyright
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${part} EXCLUDE_FROM_ALL)
endforeach()

include(CPack)
