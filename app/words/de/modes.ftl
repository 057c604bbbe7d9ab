modes-strip = Eigenschwingungen
modes-close = Eigenschwingungen schließen
    .hint = Schließen
modes-how = Zeige auf einen Balken, oder gehe mit Tab hin: So schwingt der Körper dabei. Zieh ihn nach oben: Der Körper schwingt so. Halte ihn gedrückt, oder die Leertaste: Er wird angetrieben.
modes-looking = Die Eigenschwingungen werden gesucht.
modes-none = Keine Eigenschwingungen: { $why }.
modes-still = um seine Ruhelage schwingt er nicht
modes-shown = Die Eigenschwingungen sind über der Zeitleiste zu sehen
modes-reading = { $swings ->
    [no] Schwingung { $number }: { $frequency } Hz, { $amplitude }, schwingt nicht, { $share } der Energie
   *[yes] Schwingung { $number }: { $frequency } Hz, { $amplitude }, Dämpfungsgrad { $damping }, { $share } der Energie
}
modes-reading-driven = { $swings ->
    [no] Schwingung { $number }: { $frequency } Hz, { $amplitude }, schwingt nicht, angetrieben
   *[yes] Schwingung { $number }: { $frequency } Hz, { $amplitude }, Dämpfungsgrad { $damping }, angetrieben
}
modes-others = In keiner davon: schnellere Schwingungen und was eine große Bewegung über kleine hinaus hat: { $share } der Energie
    .lacks = In keiner davon: schnellere Schwingungen und was eine große Bewegung über kleine hinaus hat; die Schwingungen allein hätten { $share } mehr
    .word = sonst
modes-share = { $percent } %
    .least = weniger als 0,1 %
modes-bar = Schwingung { $number }, { $frequency } Hertz
    .others = In keiner Schwingung
modes-value = { $amplitude }, { $share } der Energie
modes-driven = Schwingung { $number } wird angetrieben
modes-level = Schwingung { $number }: { $percent } Prozent eines vollen Balkens
modes-volume = Lautstärke
modes-sound = Klang der Eigenschwingungen
    .on = Klang: an
    .off = Klang: aus
