# What `cmake --install` puts where: bin/isolux, which finds the programs that are its own in libexec/isolux
# (app/launcher/main.cpp), and what a desktop wants to know about it.
include(GNUInstallDirs)

# The manual page is made of the program's own help.
set(man_page ${PROJECT_BINARY_DIR}/isolux.1)
add_custom_command(OUTPUT ${man_page}
  COMMAND isolux_program --man-page > ${man_page}
  DEPENDS isolux_program VERBATIM)
add_custom_target(isolux_man_page ALL DEPENDS ${man_page})

install(TARGETS isolux DESTINATION bin)
install(TARGETS isolux_program DESTINATION libexec/isolux)  # and the readers: readers/CMakeLists.txt
install(FILES ${man_page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/isolux RENAME copyright)
install(FILES resources/desktop/isolux.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES resources/desktop/isolux.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES resources/icons/isolux.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
