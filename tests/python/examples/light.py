"""Stored light in a file."""

import isolux

v = isolux.open("phantom:torus:32")
scene = {"environment": "sunset", "settings": {"gi.samples": 64, "gi.texels": "own"}}  # light for every isovalue
stats = v.bake("torus_light.vti", **scene)
print(stats.bake.texels, "texels,", stats.bake.rays, "rays")
v.render(look="gi", size=(320, 240), light="torus_light.vti", **scene).save("python_light.png")
