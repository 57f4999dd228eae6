"""A picture."""

import isolux

v = isolux.open("phantom:head:64")
p = v.render(isovalue=300, look="gi", size=(320, 240), environment="studio")
p.save("python_first.png")
