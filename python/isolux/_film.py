"""Pictures one after the other, as a film."""

import os
import shutil
import subprocess

import numpy as np


def film(pictures, path, fps=24):
    """Writes pictures (Pictures or uint8 arrays of one size, as they come) as a film; needs ffmpeg. Returns `path`."""
    program = shutil.which("ffmpeg")
    if program is None:
        raise RuntimeError("a film needs ffmpeg, which was not found")
    path = os.fsdecode(path)
    if not path.lower().endswith((".mp4", ".webm", ".mkv", ".gif")):
        raise ValueError(f"{path}: the name of a film must end in .mp4, .webm, .mkv or .gif")
    stem, ending = os.path.splitext(path)
    unfinished = f"{stem}.part{ending}"
    writer = size = None
    try:
        for picture in pictures:
            frame = np.ascontiguousarray(np.asarray(picture)[..., :3], dtype=np.uint8)
            if writer is None:
                size = frame.shape
                writer = subprocess.Popen(_command(program, size, fps, unfinished), stdin=subprocess.PIPE,
                                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            if frame.shape != size:
                raise ValueError(f"pictures of a film are of one size, not {size[1]} x {size[0]} and {frame.shape[1]} x {frame.shape[0]}")
            try:
                writer.stdin.write(frame.tobytes())
            except BrokenPipeError:  # it has ended, and says why
                break
        if writer is None:
            raise ValueError("a film needs pictures")
        said = writer.communicate()[1]
        if writer.returncode != 0:
            raise RuntimeError("ffmpeg: " + said.decode(errors="replace").strip().splitlines()[-1])
        os.replace(unfinished, path)
    finally:
        if writer is not None and writer.poll() is None:
            writer.kill()
            writer.communicate()
        if os.path.exists(unfinished):
            os.remove(unfinished)
    return path


def _command(program, size, fps, path):
    even = "crop=trunc(iw/2)*2:trunc(ih/2)*2"
    coded = [] if path.endswith(".gif") else ["-pix_fmt", "yuv420p"]
    return [program, "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{size[1]}x{size[0]}", "-r",
            str(fps), "-i", "-", "-vf", even, *coded, path]
