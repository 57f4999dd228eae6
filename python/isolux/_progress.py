"""How far long work is: a bar on a terminal, a line of text in a notebook, or a caller's own function."""

import sys
import time


class Bar:
    """Called with (fraction, stage); `close()` takes the line away."""

    def __init__(self, out=None):
        self._out = out or (sys.stdout if _in_notebook() else sys.stderr)
        self._width = 0
        self._stage, self._start = None, time.monotonic()

    def __call__(self, fraction, stage):
        now = time.monotonic()
        if stage != self._stage:
            self._stage, self._start = stage, now
        gone = now - self._start
        left = f", {_clock(gone * (1 - fraction) / fraction)} left" if fraction > 0.02 and gone > 1 else ""
        filled = int(round(20 * min(max(fraction, 0.0), 1.0)))
        text = f"{stage or 'working'}: {100 * fraction:3.0f}%|{'#' * filled}{' ' * (20 - filled)}| {_clock(gone)}{left}"
        self._write(text)

    def close(self):
        if self._width:
            self._write("")
            self._out.write("\r")
            self._out.flush()

    def _write(self, text):
        self._out.write("\r" + text.ljust(self._width))
        self._out.flush()
        self._width = len(text)


def _clock(seconds):
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d}"


def _in_notebook():
    return "ipykernel" in sys.modules


class told:
    """`progress` as the compiled part takes it: None, a function, or True for a bar."""

    def __init__(self, progress):
        if progress is not None and not isinstance(progress, bool) and not callable(progress):
            raise TypeError("progress: True, or a function of (fraction, stage)")
        self._bar = Bar() if progress is True else None
        self._call = self._bar if self._bar else (progress or None)

    def __enter__(self):
        return self._call

    def __exit__(self, *_):
        if self._bar:
            self._bar.close()
