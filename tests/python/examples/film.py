"""A film."""

import isolux

v = isolux.open("phantom:torus:48")
frames = [v.render(look="normal", size=(320, 240), azimuth=a, elevation=20) for a in range(0, 360, 30)]
isolux.film(frames, "torus.mp4", fps=12)
frames[2].save("python_film.png")
