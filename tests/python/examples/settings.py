"""Settings: a cut, lines, another camera."""

import isolux

v = isolux.open("phantom:head:64")
p = v.render(300, "tone", (320, 240), view="left", fit="surface",
             settings={"look.ridges": 1, "clip.planes": [[0, 0, 20, 0, 0, -1]]})
p.save("python_settings.png")
