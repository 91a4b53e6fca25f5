# What `cmake --install` puts where, and the Debian package by `cpack -G DEB`: the component
# `program` alone. Included by the root, whose names it uses.
install(TARGETS quern_soa quern_kernels quern_scheduler quern_io EXPORT quernTargets
        ARCHIVE COMPONENT library)
# find_package(quern) gives quern::soa, ::kernels, ::scheduler, ::io and ::quern (all of them).
# Headers keep their folders below include/quern.
set(quern_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/quern)
install(EXPORT quernTargets NAMESPACE quern:: DESTINATION ${quern_cmake_dir} COMPONENT library)
install(DIRECTORY soa kernels scheduler io DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/quern
        COMPONENT library FILES_MATCHING PATTERN "*.h" PATTERN "*-inl.h" EXCLUDE)
configure_package_config_file(quernConfig.cmake.in ${CMAKE_BINARY_DIR}/quernConfig.cmake
                              INSTALL_DESTINATION ${quern_cmake_dir})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/quernConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/quernConfig.cmake ${CMAKE_BINARY_DIR}/quernConfigVersion.cmake
        DESTINATION ${quern_cmake_dir} COMPONENT library)

# Scenes name their shapes by ../shapes.
install(TARGETS quern RUNTIME COMPONENT program)
install(DIRECTORY apps/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/quern COMPONENT program)
install(DIRECTORY apps/shapes DESTINATION ${CMAKE_INSTALL_DATADIR}/quern COMPONENT program
        FILES_MATCHING PATTERN "*.stl")
install(FILES README.md LICENSE apps/packaging/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT program)
# For a prefix that is not searched by itself; the package has no need of it.
install(FILES apps/packaging/modulefile DESTINATION ${CMAKE_INSTALL_DATADIR}/modulefiles/quern
        RENAME ${PROJECT_VERSION} COMPONENT module)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME quern)
set(CPACK_PACKAGE_CONTACT "The developers of quern <quern@localhost>")
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "discrete-element simulation of grinding mills
Fills a mill with ore and media, turns it, and tells the power, where the
energy goes, how the charge moves and the liner wears. Spheres and convex
polyhedra; the same bits for any number of threads and after a restart.
Scenes are in /usr/share/quern/scenes.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
include(CPack)
