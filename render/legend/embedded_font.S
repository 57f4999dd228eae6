/* The bytes of the font file ISOLUX_FONT_FILE, as read-only data of the program (render/legend/font.cpp). */
  .section .rodata
  .global isoluxFontBegin
  .global isoluxFontEnd
  .balign 16
isoluxFontBegin:
  .incbin ISOLUX_FONT_FILE
isoluxFontEnd:
  .byte 0
  .section .note.GNU-stack, "", %progbits
