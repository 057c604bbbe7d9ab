"""Tables as programs write them: what each is read as, or the sentence that refuses it.

A row is the name, the file, and either the runs, each with its times and columns ("name [unit]"), or the
sentence. Files are written down as these programs export them; numbers are few.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

NAN = float("nan")
Columns = dict[str, list[float]]


class Written(NamedTuple):
    """A table, and what it is to be read as.

    Attributes:
        by: the program, and what is odd about it.
        file: as text, which is UTF-8, or as bytes.
        runs: the times, s, and the columns of each measurement.
        refused: the sentence without the file's name, instead.
        remarks: how many things are said about it.
    """

    by: str
    file: str | bytes
    runs: Sequence[tuple[list[float], Columns]] = ()
    refused: str = ""
    remarks: int = 0


T, X = [0.0, 0.5, 1.0], [1.0, 1.5, 2.0]
"""Times and places of most."""
TWO, THREE = [(T[:2], {"x": X[:2]})], [(T, {"x": X})]
"""One run of so many rows."""


def two_runs(name: str) -> Sequence[tuple[list[float], Columns]]:
    return [(T[:2], {name: X[:2]}), ([0.0, 1.0], {name: [3.0, 4.0]})]


TABLES = (
    # ------------------------------------------------------------------ several runs
    Written(
        "Logger Pro, two runs with clocks of their own",
        "Time (s),y (m),Time (s),y (m)\n0,1,0,3\n0.5,1.5,1,4\n1,2,2,5\n",
        [(T, {"y [m]": X}), ([0.0, 1.0, 2.0], {"y [m]": [3.0, 4.0, 5.0]})],
    ),
    Written("t and x twice", "t,x,t,x\n0,1,0,3\n0.5,1.5,1,4\n", two_runs("x")),
    Written("numbered clocks", "t1,x1,t2,x2\n0,1,0,3\n0.5,1.5,1,4\n", two_runs("x")),
    Written("clocks first", "t1,t2,x1,x2\n0,0,1,3\n0.5,1,1.5,4\n", two_runs("x")),
    Written(
        "a second clock with a mark",
        "Time [s],x [m],Time' [s],x' [m]\n0,1,0,3\n0.5,1.5,1,4\n",
        two_runs("x [m]"),
    ),
    Written(
        "DataStudio, runs in a line above",
        "Run 1\t\tRun 2\t\nTime (s)\ty (m)\tTime (s)\ty (m)\n0\t1\t0\t3\n0.5\t1.5\t1\t4\n",
        two_runs("y [m]"),
    ),
    Written(
        "Capstone, the second run shorter",
        '"Time (s) Run #1","Position (m) Run #1","Time (s) Run #2","Position (m) Run #2"\n0,1,0,3\n'
        "0.5,1.5,1,4\n1,2,,\n",
        [(T, {"Position [m]": X}), ([0.0, 1.0], {"Position [m]": [3.0, 4.0]})],
    ),
    Written(
        "Capstone, two sensors by one clock",
        '"Time (s) Run #1","Position (m) Run #1","Time (s) Run #1","Force (N) Run #1"\n0,1,0,3\n'
        "0.5,1.5,0.5,4\n",
        [(T[:2], {"Position [m]": X[:2], "Force [N]": [3.0, 4.0]})],
    ),
    Written(
        "Graphical Analysis, data sets",
        "Data Set 1:Time(s),Data Set 1:Position(m),Data Set 2:Time(s),Data Set 2:Position(m)\n"
        "0,1,0,3\n0.5,1.5,1,4\n",
        two_runs("Position [m]"),
    ),
    Written(
        "Logger Pro, latest",
        '"Latest: Time (s)","Latest: Position (m)"\n0,1\n0.5,1.5\n1,2\n',
        [(T, {"Position [m]": X})],
    ),
    Written("SPARKvue", "Time (s) Run 1,Force (N) Run 1\n0,1\n0.5,1.5\n1,2\n", [(T, {"Force [N]": X})]),
    Written(
        "Tracker, two points with clocks of their own",
        "mass A\t\t\tmass B\t\t\nt\tx\ty\tt\tx\ty\n0\t1\t2\t0.5\t3\t4\n0.5\t1.5\t2.5\t1\t5\t6\n",
        [
            (
                T,
                {
                    "mass A x": [1, 1.5, NAN],
                    "mass A y": [2, 2.5, NAN],
                    "mass B x": [NAN, 3, 5],
                    "mass B y": [NAN, 4, 6],
                },
            )
        ],
    ),
    Written(
        "Capstone, two sensors of one run at two rates",
        '"Time (s) Run #1","Position (m) Run #1","Time (s) Run #1","Force (N) Run #1"\n0,1,0,3\n'
        "0.5,1.5,1,4\n1,2,,\n",
        [(T, {"Position [m]": X, "Force [N]": [3.0, NAN, 4.0]})],
    ),
    Written(
        "a temperature called t beside the time",
        "time (s),t (°C),x (cm)\n0,20,1\n0.5,21,1.5\n",
        [(T[:2], {"t [°C]": [20.0, 21.0], "x [cm]": X[:2]})],
    ),
    Written(
        "a time of day beside the time",
        "time (s),Started,x\n0,12:00:00,1\n0.5,12:00:00,1.5\n",
        TWO,
        remarks=1,
    ),
    Written(
        "two clocks that are the same, and one since 1970",
        "timestamp,t (s),x,t (s),y\n1486500000000,0,1,0,3\n1486500000500,0.5,1.5,0.5,4\n",
        [(T[:2], {"x": X[:2], "y": [3.0, 4.0]})],
        remarks=1,
    ),
    Written(
        "two clocks that nothing tells apart",
        "time,Time,x,y\n0,0,1,3\n0.5,1,1.5,4\n",
        refused="there are several clocks, 'time' and 'Time', and it is not told which column goes "
        "with which",
    ),
    # ------------------------------------------------------------------ clocks
    Written(
        "a logger with milliseconds since 1970 beside a relative time",
        "timestamp,relative_time,value\n1486500000000,0,1\n1486500000500,500,1.5\n1486500001000,1000,2\n",
        [(T, {"value": X})],
        remarks=1,
    ),
    Written(
        "Sensor Logger, nanoseconds since 1970",
        "time,seconds_elapsed,z\n1672531200000000000,0.0,1\n1672531200500000000,0.5,1.5\n"
        "1672531201000000000,1.0,2\n",
        [(T, {"z": X})],
        remarks=1,
    ),
    Written(
        "a relative time at another rate",
        "timestamp,relative_time,value\n1486500000000,0,1\n1486500000500,7,1.5\n1486500001000,14,2\n",
        refused="'relative_time' has no unit, and 'timestamp' goes at another rate",
    ),
    Written(
        "seconds since 1970",
        "timestamp,value\n1486500000.0,1\n1486500000.5,1.5\n1486500001,2\n",
        [([1486500000.0, 1486500000.5, 1486500001.0], {"value": X})],
    ),
    Written("h:mm:ss", "time,x\n0:00:00,1\n0:00:00.5,1.5\n0:00:01,2\n", THREE),
    Written("Kinovea, h:mm:ss with a comma", "Zeit;x\n0:00:00,00;1\n0:00:00,50;1,5\n0:00:01,00;2\n", THREE),
    Written(
        "Physics Toolbox, h:mm:ss:ms",
        "time,gFx\n10:15:32:000,1\n10:15:32:500,1.5\n10:15:33:000,2\n",
        [([36932.0, 36932.5, 36933.0], {"gFx": X})],
    ),
    Written(
        "Kinovea, hundredths or pictures",
        "time,x\n0:00:00:00,1\n0:00:00:50,1.5\n",
        refused="column 'time': 0:00:00:00 may end in parts of a second or in pictures; write it as "
        "h:mm:ss.ff",
    ),
    Written(
        "minutes or hours",
        "time,x\n00:00,1\n00:01,2\n",
        refused="column 'time': 00:00 may be minutes or hours; write it as h:mm:ss",
    ),
    Written("m:ss.f", "time,x\n0:00.0,1\n0:00.5,1.5\n0:01.0,2\n", THREE),
    Written("over midnight", "time,x\n23:59:59.5,1\n0:00:00.0,1.5\n", [([86399.5, 86400.0], {"x": X[:2]})]),
    Written(
        "in the afternoon",
        "time,x\n12:59:59.5 PM,1\n1:00:00.0 PM,1.5\n",
        [([46799.5, 46800.0], {"x": X[:2]})],
    ),
    Written(
        "a day in a column of its own",
        "Date,Time,x\n2026-05-01,12:00:00.0,1\n2026-05-01,12:00:00.5,1.5\n",
        [([43200.0, 43200.5], {"x": X[:2]})],
        remarks=1,
    ),
    Written(
        "ISO 8601",
        "datetime,x\n1970-01-02T00:00:00.0Z,1\n1970-01-02T01:00:00.5+01:00,1.5\n",
        [([86400.0, 86400.5], {"x": X[:2]})],
    ),
    Written(
        "days that may be months, over midnight",
        "time,x\n4/5/2026 23:59:59.5,1\n5/5/2026 0:00:00.0,1.5\n",
        [([1777939199.5, 1777939200.0], {"x": X[:2]})],
    ),
    Written("a logger with milliseconds in the name", "time_ms,x\n0,1\n500,1.5\n1000,2\n", THREE),
    Written("Arduino", "millis\tx\n0\t1\n500\t1.5\n1000\t2\n", THREE),
    Written("microseconds", "t (µs),x\n0,1\n500000,1.5\n1000000,2\n", THREE),
    Written("nanoseconds", "t (ns),x\n0,1\n500000000,1.5\n1000000000,2\n", THREE),
    Written("minutes", "t (minutes),x\n0,1\n0.5,1.5\n1,2\n", [([0.0, 30.0, 60.0], {"x": X})]),
    Written("hours", "t (h),x\n0,1\n0.5,1.5\n1,2\n", [([0.0, 1800.0, 3600.0], {"x": X})]),
    Written("Japanese seconds", "時間 (秒),x\n0,1\n0.5,1.5\n1,2\n", THREE),
    Written("German seconds", "Zeit (Sekunden);x\n0;1\n0,5;1,5\n1;2\n", THREE),
    Written("seconds called S", "t (S),x\n0,1\n0.5,1.5\n1,2\n", THREE),
    Written("the time in the second column", "x (m),Время (с)\n1,0\n1.5,0.5\n2,1\n", [(T, {"x [m]": X})]),
    Written(
        "a unit that is none of time",
        "t (°C),x\n0,1\n1,2\n",
        refused="the time 't' is in '°C', and not in s, ms, min or h",
    ),
    Written(
        "no time",
        "x (cm),y (cm)\n0,1\n1,2\n",
        refused="no column is called the time, and the first one is 'x' in cm; call one t (s)",
    ),
    Written(
        "numbers of pictures",
        "frame,x\n0,1\n1,2\n",
        refused="no column is called the time, and the first one is 'frame'; call one t (s)",
    ),
    Written("a first column with another name", "phase,x\n0,1\n0.5,1.5\n1,2\n", THREE, remarks=1),
    Written(
        "a number without a time", "t,x\n0,1\n,1.5\n1,2\n", refused="line 3: it has numbers, but no time"
    ),
    # ------------------------------------------------------------------ spreadsheets of many countries
    Written(
        "Excel in French",
        "Temps (s);x (m)\r\n0;1 000,5\r\n0,5;1\u202f001,5\r\n".replace("1 000", "1\u00a0000"),
        [(T[:2], {"x [m]": [1000.5, 1001.5]})],
    ),
    Written(
        "Excel in Russian", "Время, с;x, м\r\n0;1\r\n0,5;1,5\r\n".encode("cp1251"), [(T[:2], {"x, м": X[:2]})]
    ),
    Written(
        "Excel in German, with thousands",
        "Zeit (s);x (mm)\r\n0;1.000,5\r\n0,5;1.001\r\n",
        [(T[:2], {"x [mm]": [1000.5, 1001.0]})],
    ),
    Written(
        "Excel in German, umlauts of Windows",
        "Zeit / s;Höhe / cm\r\n0;1\r\n0,5;1,5\r\n".encode("cp1252"),
        [(T[:2], {"Höhe [cm]": X[:2]})],
    ),
    Written("Excel, Unicode text", "t (s)\tx\r\n0\t1\r\n0,5\t1,5\r\n".encode("utf-16"), TWO),
    Written("Excel, what stands between", "sep=;\r\nt;x\r\n0;1\r\n0,5;1,5\r\n", TWO),
    Written("Excel, a heading of two lines", 't (s),"x\n(cm)"\n0,1\n0.5,1.5\n', [(T[:2], {"x [cm]": X[:2]})]),
    Written("LibreOffice, quoted decimal commas", '"t","x"\n"0,0","1,0"\n"0,5","1,5"\n', TWO),
    Written(
        "Google Sheets, thousands", 't,x\n0,"1,000.5"\n0.5,"1,001"\n', [(T[:2], {"x": [1000.5, 1001.0]})]
    ),
    Written("Swiss thousands", "t;x\n0;1'000.5\n0.5;1’001.5\n", [(T[:2], {"x": [1000.5, 1001.5]})]),
    Written(
        "a thousand, or one and a bit",
        "t;x\n1;1,250\n2;2,500\n",
        refused="line 2: '1,250' may be 1250 or 1.250; write it in one of these ways",
    ),
    Written("Word's minus", "t,x\n0,\u22121.5\n0.5,\u22121.4\n1,1\n", [(T, {"x": [-1.5, -1.4, 1.0]})]),
    Written(
        "one comma among points",
        "t;x\n0.0;1.0\n0.5;1.5\n1,2e-08;2.0\n",
        refused="line 4: '1,2e-08' has another decimal sign than '0.0' in line 2",
    ),
    Written(
        "decimal commas between commas",
        "t,x\n0,5,1,5\n1,5,2,5\n",
        refused="line 2: it has 4 cells below 2 names; where a comma stands between cells, the "
        "decimal sign is a point",
    ),
    Written(
        "a formula in the first row",
        "t,x\n=1+1,2\n0.1,3\n",
        refused="line 2: '=1+1' is a formula, and not a number",
    ),
    Written(
        "a formula of Lotus",
        "t,x\n0,@SUM\n0.5,1\n1,2\n",
        refused="line 2: '@SUM' is a formula, and not a number",
    ),
    Written("a word in the first row", "t,x\n0,oops\n0.5,1\n1,2\n", refused="line 2: 'oops' is not a number"),
    Written(
        "a cell without end",
        "t,x\n0," + "1" * 140_000 + "\n0.5,1\n",
        refused="line 2: it is longer than 100000 letters",
    ),
    # ------------------------------------------------------------------ gaps, comments, others
    *(
        Written(
            f"{gap} for a gap",
            f"t,x,y\n0,{gap},3\n0.5,1.5,{gap}\n1,2,4\n",
            [(T, {"x": [NAN, 1.5, 2.0], "y": [3.0, NAN, 4.0]})],
        )
        for gap in ("NaN", "nan", "-", "--", "n/a", "NA", "null", "#N/A", "#NV", "—")
    ),
    Written(
        "a line of gaps between the first numbers", "t,x\n0,NaN\nNA\n0.5,1.5\n1,2\n", [(T[1:], {"x": X[1:]})]
    ),
    Written("gaps before the first number", "t,x\n0,NaN\n0.5,1.5\n1,2\n", [(T[1:], {"x": X[1:]})]),
    Written("a gap of a spreadsheet in front", "x,t\n#N/A,0\n1.5,0.5\n2,1\n", [(T[1:], {"x": X[1:]})]),
    Written("comments with semicolons", "; by hand\nt,x\n0,1\n; then\n0.5,1.5\n", TWO),
    Written("NumPy's heading", "# t x\n0.0 1.0\n0.5 1.5\n", TWO),
    Written("a column of words", "t,state,x\n0,ok,1\n0.5,ok,1.5\n", TWO, remarks=1),
    Written("bars", "t|x\n0|1\n0.5|1.5\n", TWO),
    Written(
        "a logger that began anew",
        "t,x\n0,1\n0.5,1.5\nt,x\n0,1\n",
        refused="line 4, column 't': 't' is not a finite number",
    ),
    Written(
        "steering signs in a heading",
        "t,\x1b[31mx\u202e (cm)\n0,1\n0.5,1.5\n",
        [(T[:2], {"[31mx [cm]": X[:2]})],
    ),
)
