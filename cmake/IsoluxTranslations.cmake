# isolux_translations(TARGET LANGUAGE ...): resources/translations/isolux_LANGUAGE.ts, compiled by Qt's lrelease and
# embedded as :/translations/isolux_LANGUAGE.qm. By hand, not by AUTORCC, which wants its files to be there already.
find_program(LRELEASE NAMES lrelease lrelease-qt6 HINTS ${QT6_INSTALL_PREFIX}/${QT6_INSTALL_BINS} /usr/lib/qt6/bin
  REQUIRED)

function(isolux_translations target)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/translations)
  set(compiled)
  set(entries)
  foreach(language IN LISTS ARGN)
    set(source ${PROJECT_SOURCE_DIR}/resources/translations/isolux_${language}.ts)
    set(result ${folder}/isolux_${language}.qm)
    add_custom_command(OUTPUT ${result}
      COMMAND ${LRELEASE} -silent ${source} -qm ${result}
      DEPENDS ${source} VERBATIM)
    list(APPEND compiled ${result})
    string(APPEND entries "    <file>isolux_${language}.qm</file>\n")
  endforeach()
  file(CONFIGURE OUTPUT ${folder}/translations.qrc
    CONTENT "<RCC>\n  <qresource prefix=\"/translations\">\n${entries}  </qresource>\n</RCC>\n")
  set(embedded ${folder}/qrc_translations.cpp)
  add_custom_command(OUTPUT ${embedded}
    COMMAND Qt6::rcc --name translations --output ${embedded} ${folder}/translations.qrc
    DEPENDS ${compiled} ${folder}/translations.qrc VERBATIM)
  set_source_files_properties(${embedded} PROPERTIES SKIP_AUTOGEN ON)
  target_sources(${target} PRIVATE ${embedded})
endfunction()
