# What `cmake --install` puts where: bin/isolux, which finds the programs that are its own in libexec/isolux
# (app/launcher/main.cpp), and what a desktop wants to know about it.
include(GNUInstallDirs)

# The manual page and the completions of shells are made of the program's own help.
set(made_files)
foreach(made man:isolux.1 bash:isolux.bash zsh:_isolux fish:isolux.fish)
  string(REPLACE ":" ";" made ${made})
  list(GET made 0 page)
  list(GET made 1 file)
  add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/${file}
    COMMAND isolux_program --made-page ${page} > ${PROJECT_BINARY_DIR}/${file}
    DEPENDS isolux_program VERBATIM)
  list(APPEND made_files ${PROJECT_BINARY_DIR}/${file})
endforeach()
add_custom_target(isolux_made_files ALL DEPENDS ${made_files})

install(TARGETS isolux DESTINATION bin)
install(TARGETS isolux_program DESTINATION libexec/isolux)  # and the readers: readers/CMakeLists.txt
install(FILES ${PROJECT_BINARY_DIR}/isolux.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_BINARY_DIR}/isolux.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME isolux)
install(FILES ${PROJECT_BINARY_DIR}/_isolux DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${PROJECT_BINARY_DIR}/isolux.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
foreach(folder start guide howto reference explanation)
  install(DIRECTORY docs/${folder} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/isolux FILES_MATCHING PATTERN "*.md")
  install(DIRECTORY docs/images/${folder} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/isolux/images OPTIONAL)
endforeach()
install(FILES docs/index.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/isolux)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/isolux RENAME copyright)
install(FILES resources/desktop/isolux.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES resources/desktop/isolux.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES resources/icons/isolux.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
