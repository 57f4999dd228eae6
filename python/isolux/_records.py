"""Answers with names: dictionaries whose keys are attributes, too."""


class Record(dict):
    """What a question answers: `r["area_mm2"]["value"]` or `r.area_mm2.value`."""

    def __init__(self, values=()):
        super().__init__()
        for key, value in dict(values).items():
            self[key] = _recorded(value)

    def __getattr__(self, name):
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"there is no {name!r}; there are: {', '.join(map(str, self))}") from None

    def __dir__(self):
        return [*super().__dir__(), *(key for key in self if isinstance(key, str) and key.isidentifier())]


def _recorded(value):
    if isinstance(value, dict) and not isinstance(value, Record):
        return Record(value)
    if isinstance(value, list):
        return [_recorded(one) for one in value]
    return value
