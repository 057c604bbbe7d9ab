fit-about = Eine Tabelle, die du auf die Seite ziehst, wird über den Körper gezeichnet, und die Szene lässt sich an sie anpassen. { $link } liefert eine.
    .link = Messen in einem Video
fit-table = { $count ->
    [one] <b>{ $name }</b>: { $count } Zeile. Welche Größe ist jede Spalte?
   *[other] <b>{ $name }</b>: { $count } Zeilen. Welche Größe ist jede Spalte?
}
fit-run = Durchgang
fit-column = wie mass1.x, -mass1.y, 90 - spring0.direction oder eine Formel; leer, um sie wegzulassen
fit-scale = { $unit } je Meter
    .hint = wie groß ein Meter der Tabelle in der Szene ist
fit-sought = Was wird gesucht?
fit-start = Anfang (Orte, Geschwindigkeiten)
fit-origin = Nullpunkt der Tabelle
fit-length-scale = Längenmaßstab
fit-fit = Anpassen
fit-forget = Tabelle vergessen
fit-begins = Die Anpassung beginnt ...
fit-goes-on = Anpassung: { $what } ...
fit-cannot = <b>Anpassen geht nicht</b>: { $why }.
fit-error = Auf dem Server gab es einen Fehler.
fit-no-table = es gibt keine Tabelle
fit-many-masses = eine Seite passt höchstens { $count } Massen an; softrod fit schafft mehr
fit-many-numbers = eine Seite passt höchstens { $count } Zahlen an; softrod fit schafft mehr
fit-no-scale = schreibe, wie viele { $unit } der Szene ein Meter sind, 0.000001..1e9, oder lass den Längenmaßstab suchen
fit-choose = wähle 1 bis { $most } gesuchte Zahlen, nicht { $count }
fit-compiling = der Löser wird noch kompiliert; versuche es gleich noch einmal
fit-changed = die Szene wurde inzwischen geändert; passe sie noch einmal an
fit-left = { $column }: übrig bleibt { $noise }.
