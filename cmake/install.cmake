# What `cmake --install` brings, in two parts: the program, and the library for other programs
# (find_package(boxbeam), target boxbeam::boxbeam).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS boxbeam RUNTIME COMPONENT program)
if(BOXBEAM_MPI)
  install(TARGETS boxbeam_mpi LIBRARY DESTINATION lib/boxbeam COMPONENT program)
endif()
install(DIRECTORY sections/ DESTINATION ${CMAKE_INSTALL_DATADIR}/boxbeam/sections COMPONENT program)
# For editors that complete and check a case by its schema.
install(FILES ${CMAKE_BINARY_DIR}/share/case.schema.json ${CMAKE_BINARY_DIR}/share/results.schema.json
  DESTINATION ${CMAKE_INSTALL_DATADIR}/boxbeam/schema COMPONENT program)

# The manual page, the completions and the schema of a case are written by the program itself.
find_program(GZIP gzip REQUIRED)
set(written ${CMAKE_BINARY_DIR}/share)
file(MAKE_DIRECTORY ${written})
add_custom_command(
  OUTPUT ${written}/boxbeam.1.gz ${written}/boxbeam.bash ${written}/_boxbeam
    ${written}/case.schema.json ${written}/results.schema.json
  COMMAND boxbeam manual > ${written}/boxbeam.1
  COMMAND ${GZIP} -9nf ${written}/boxbeam.1
  COMMAND boxbeam completion bash > ${written}/boxbeam.bash
  COMMAND boxbeam completion zsh > ${written}/_boxbeam
  COMMAND boxbeam schema case > ${written}/case.schema.json
  COMMAND boxbeam schema results > ${written}/results.schema.json
  DEPENDS boxbeam VERBATIM)
add_custom_target(boxbeam_share ALL
  DEPENDS ${written}/boxbeam.1.gz ${written}/boxbeam.bash ${written}/_boxbeam
    ${written}/case.schema.json ${written}/results.schema.json)
install(FILES ${written}/boxbeam.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${written}/boxbeam.bash RENAME boxbeam
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
# Where Debian's packages put them.
install(FILES ${written}/_boxbeam
  DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)

install(TARGETS boxbeam_library EXPORT boxbeamTargets ARCHIVE COMPONENT development)
install(DIRECTORY include/boxbeam DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/boxbeam)
install(EXPORT boxbeamTargets NAMESPACE boxbeam:: DESTINATION ${package} COMPONENT development)
configure_package_config_file(cmake/boxbeamConfig.cmake.in
  ${CMAKE_BINARY_DIR}/boxbeamConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/boxbeamConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/boxbeamConfig.cmake
  ${CMAKE_BINARY_DIR}/boxbeamConfigVersion.cmake DESTINATION ${package} COMPONENT development)
