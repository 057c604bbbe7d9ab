"""Names and notations of the time in tables: in units of time, as a time of day, or since 1970."""

from __future__ import annotations

import datetime
import math
import re
from collections.abc import Iterable

from ..text import Text

SECONDS = {
    **dict.fromkeys(("s", "sec", "secs", "sek", "second", "seconds", "sekunde", "sekunden"), 1.0),
    **dict.fromkeys(("seconde", "secondes", "segundo", "segundos", "secondi", "с", "сек", "секунды"), 1.0),
    **dict.fromkeys(("секунд", "秒"), 1.0),
    **dict.fromkeys(("ms", "msec", "millis", "millisecond", "milliseconds", "millisekunden"), 1e-3),
    **dict.fromkeys(("мс", "мсек", "毫秒", "ミリ秒"), 1e-3),
    **dict.fromkeys(("µs", "μs", "us", "usec", "micros", "microseconds", "мкс"), 1e-6),
    **dict.fromkeys(("ns", "nsec", "nanos", "nanoseconds", "нс"), 1e-9),
    **dict.fromkeys(("min", "mins", "minute", "minutes", "minuten", "мин"), 60.0),
    **dict.fromkeys(("h", "hr", "hrs", "hour", "hours", "std", "stunden", "ч", "час"), 3600.0),
}
"""Seconds in each unit of time, by its name in lower case."""

_TIMES = (
    "t", "time", "times", "zeit", "temps", "tiempo", "tempo", "czas", "tid", "tijd", "čas", "aika", "idő",
    "время", "zaman", "时间", "時間", "seconds", "millis", "micros", "timestamp", "time stamp", "datetime",
    "date time", "date/time", "uhrzeit", "zeitstempel", "horodatage", "clock",
)  # fmt: skip
"""Names of the time, in the languages that are common in exports."""
_SINCE_START = (
    "relative time", "time relative", "elapsed", "elapsed time", "time elapsed", "seconds elapsed",
    "time since start", "relative zeit", "verstrichene zeit", "t rel", "rel time",
)  # fmt: skip
"""Names of a time that starts with the measurement."""

_NUMBERED = re.compile(r"(.*?)[ _]?\d{0,3}'*", re.DOTALL)
_DATE = re.compile(r"\d{1,4}([-./])\d{1,2}\1\d{1,4}", re.ASCII)
_OF_DAY = re.compile(
    r"(?:(?P<date>\d{1,4}[-./]\d{1,2}[-./]\d{1,4})[T ,]\s*)?"
    r"(?P<h>\d{1,4}):(?P<m>[0-5]?\d):(?P<s>[0-5]?\d)(?:(?P<sign>[.,:])(?P<part>\d{1,9}))?"
    r"\s*(?P<half>[ap]\.?m\.?)?\s*(?P<zone>Z|UTC|[-+]\d\d:?\d\d)?",
    re.IGNORECASE | re.ASCII,
)
_MINUTES = re.compile(r"(?P<m>\d{1,4}):(?P<s>[0-5]\d)[.,](?P<part>\d{1,9})", re.ASCII)
_HALF_TOLD = re.compile(r"\d{1,4}:[0-5]?\d", re.ASCII)

DAY = 86400.0
"""Seconds in a day."""


def is_clock(name: str) -> bool:
    """Return whether a column is the time, by its name; "T" is a temperature or a period."""
    return name.strip() != "T" and (_plain(name) in _TIMES or begins_with_start(name))


def begins_with_start(name: str) -> bool:
    """Return whether a column is the time since the measurement began, by its name."""
    return _plain(name) in _SINCE_START


def number_of(name: str) -> str:
    """Return the number at the end of a name, as in "t2"; empty where there is none."""
    found = re.search(r"\d{1,3}$", name.rstrip("'"))
    return found.group() if found else ""


def _plain(name: str) -> str:
    match = _NUMBERED.fullmatch(name.strip().lower())
    return (match[1] if match else "").replace("_", " ").strip()


def unit_in_name(name: str) -> tuple[str, str]:
    """Return name and unit of a time whose name includes its unit, as in "time_ms", "Zeit, s" and "millis";
    otherwise the name and an empty unit."""
    lower = name.strip().lower()
    if lower in SECONDS and len(lower) > 1:
        return name, lower
    match = re.fullmatch(r"(.*?)(?:_|,\s*|\s+)(\S+)", name.strip(), re.DOTALL)
    if match and match[2].lower() in SECONDS and is_clock(match[1]):
        return match[1], match[2]
    return name, ""


def seconds_of(unit: str) -> float | None:
    """Return the seconds in a unit of time; None if it is none."""
    return SECONDS.get(unit.strip().rstrip(".").lower())


def is_time_of_day(cell: str) -> bool:
    """Return whether a cell is a clock time, with or without a date; see `times_of_day`."""
    return ":" in cell and bool(
        _OF_DAY.fullmatch(cell) or _MINUTES.fullmatch(cell) or _HALF_TOLD.fullmatch(cell)
    )


def is_date(cell: str) -> bool:
    """Return whether a cell is a date without a time."""
    return _DATE.fullmatch(cell) is not None


def times_of_day(cells: Iterable[str]) -> list[float]:
    """Return clock times in seconds; NaN for other cells.

    They are h:mm:ss or m:ss.f, with points or commas, "PM", time zones, and preceding dates in any order.
    Without a date they continue past midnight.

    Raises:
        ValueError: one of them is ambiguous. The message says how.
    """
    found = [_time_of_day(cell) for cell in cells]
    # Which number in 1/2/2026 is the day is not known: choose the order with the shorter time from the first
    # row to the last.
    spans = []
    for way in (0, 1):
        some = [each[way] for each in found if each is not None]
        spans.append(abs(some[-1] - some[0]) if some else 0.0)
    way = int(spans[1] < spans[0])
    days, before, seconds = 0.0, -math.inf, []
    for each in found:
        if each is None:
            seconds.append(math.nan)
            continue
        if each[way] < DAY and each[way] + days < before - 0.5 * DAY:
            days += DAY
        before = each[way] + days
        seconds.append(before)
    return seconds


def _time_of_day(cell: str) -> tuple[float, float] | None:
    if match := _MINUTES.fullmatch(cell):
        seconds = 60.0 * int(match["m"]) + float(f"{match['s']}.{match['part']}")
        return seconds, seconds
    if _HALF_TOLD.fullmatch(cell):
        raise ValueError(Text("{cell} may be minutes or hours; write it as h:mm:ss", cell=cell))
    match = _OF_DAY.fullmatch(cell)
    if match is None:
        return None
    part = match["part"] or "0"
    if match["sign"] == ":" and len(part) != 3:
        raise ValueError(
            Text("{cell} may end in parts of a second or in pictures; write it as h:mm:ss.ff", cell=cell)
        )
    hours = int(match["h"])
    if match["half"]:
        hours = hours % 12 + (12 if match["half"][0] in "pP" else 0)
    seconds = 3600.0 * hours + 60.0 * int(match["m"]) + float(f"{match['s']}.{part}")
    zone = match["zone"] or ""
    if zone[:1] in ("+", "-"):
        digits = zone[1:].replace(":", "")
        seconds -= float(f"{zone[0]}1") * (3600.0 * int(digits[:2]) + 60.0 * int(digits[2:]))
    if not match["date"]:
        return seconds, seconds
    days = _days_of(match["date"])
    if days is None:
        raise ValueError(Text("{cell}: there is no such day", cell=cell))
    return days[0] * DAY + seconds, days[1] * DAY + seconds


def _days_of(date: str) -> tuple[float, float] | None:
    """Return a date's days since 1970, with the month before the day and after it; None if invalid."""
    a, b, c = (int(part) for part in re.split(r"[-./]", date))
    if a > 31:
        ways = ((a, b, c), (a, b, c))
    elif "." in date:
        ways = ((c, b, a), (c, b, a))
    else:
        ways = ((c, a, b), (c, b, a))
    found = []
    for year, month, day in ways:
        try:
            at = datetime.date(year + (2000 if year < 100 else 0), month, day)
        except ValueError:
            continue
        found.append(float((at - datetime.date(1970, 1, 1)).days))
    return (found[0], found[-1]) if found else None


_SINCE_1970 = ((1e8, 1e10, 1.0), (1e11, 1e13, 1e-3), (1e14, 1e16, 1e-6), (1e17, 1e19, 1e-9))
"""Ranges of numbers that count the time since 1970 (until 2286), with the seconds in their unit."""


def unit_since_1970(first: float) -> float | None:
    """Return the seconds in the unit of a time that can only be counted since 1970; None for any other."""
    return next((unit for low, high, unit in _SINCE_1970 if low <= first < high), None)
