// The look of the program: a dark, calm Fusion theme, and the few colours that widgets draw with themselves.
#pragma once

#include <QColor>

namespace isolux::ui {

namespace colours {
inline const QColor window{0x24, 0x28, 0x2e};
inline const QColor base{0x1a, 0x1d, 0x22};
inline const QColor raised{0x2f, 0x34, 0x3c};
inline const QColor border{0x3d, 0x44, 0x4e};
inline const QColor checkEdge{0x8a, 0x94, 0xa1};  // of boxes to check: 3 : 1 against window and base
inline const QColor text{0xe3, 0xe7, 0xec};
inline const QColor quietText{0xa3, 0xac, 0xb8};
inline const QColor disabledText{0x6b, 0x74, 0x80};
inline const QColor accent{0x4c, 0x9b, 0xd6};
inline const QColor isovalue{0xf2, 0xb1, 0x34};
inline const QColor error{0xe5, 0x6b, 0x62};
inline const QColor warning{0xe8, 0xb2, 0x4a};
}  // namespace colours

// Once, after the QApplication is made.
void applyStyle();

}  // namespace isolux::ui
