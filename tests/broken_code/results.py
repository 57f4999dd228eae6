"""What became of each change, kept as it comes in a JSON file, so that a run that was cut off goes on."""

import hashlib
import json
import os


def digest(*texts):
    return hashlib.sha256("\0".join(texts).encode()).hexdigest()[:16]


class Results:
    """state, words and seconds by key."""

    def __init__(self, path):
        self.path = path
        path.parent.mkdir(parents=True, exist_ok=True)
        self.of = json.loads(path.read_text()) if path.is_file() else {}

    def forget(self, keys):
        for key in keys:
            self.of.pop(key, None)

    def put(self, key, state, words, seconds, **more):
        self.of[key] = {"state": state, "words": words, "seconds": round(seconds, 1), **more}
        temporary = self.path.with_suffix(".new")
        temporary.write_text(json.dumps(self.of, indent=1) + "\n")
        os.replace(temporary, self.path)
