"""Area and volume, with their errors."""

import isolux

v = isolux.open("phantom:head:64")
m = v.measure(300)
print(f"area {m.area_mm2.value:.0f} ± {m.area_mm2.error:.0f} mm²")
print(f"volume {m.volume_mm3.value:.0f} ± {m.volume_mm3.error:.0f} mm³, {len(m.pieces)} pieces")
v.render(300, "lambert", (320, 240), settings={"pieces.keep": 1}).save("python_measure.png")
