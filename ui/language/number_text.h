// Numbers as people read them: enough digits, no noise, a point in every country.
#pragma once

#include <cstdint>

#include <QString>

namespace isolux::ui {

// Digits of a number in a field; of all that it says, in its tip and while it is edited.
inline constexpr int shownDigits = 4, allDigits = 15;

// At most `significant` digits, without trailing zeros; an exponent only below 1e-4 and from 1e9 on.
QString numberText(double value, int significant = 6);
// numberText with the unit behind it ("300 HU"; no unit: "300").
QString valueText(double value, const QString& unit, int significant = 6);
// "1 234 567", with narrow spaces.
QString groupedText(std::uint64_t number);
// "1.2 kB", "34 MB".
QString bytesText(double bytes);
// "cubic_interpolating" -> "Cubic interpolating", in the window's language.
QString wordsOf(const QString& identifier);
QString plainWordsOf(const QString& identifier);  // as the translations know it

}  // namespace isolux::ui
