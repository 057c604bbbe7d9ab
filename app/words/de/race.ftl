race-strip = Wettrennen
race-rule = Alle starten gleichzeitig auf dem Gelände dieses Körpers, und im Ziel zählt die Mitte von jedem. Änderungen an diesem Körper und am Gelände sind erlaubt und werden hier vermerkt; „Noch einmal“ macht es wieder fair.
race-choose = Wettrennen gegen
    .paste = Link einfügen oder unten wählen
    .link = Link zur Szene, gegen die gelaufen wird
    .go = Los
race-start = Start
    .hint = Alle vom Start, nach einem Countdown
    .again = Noch einmal
race-add = Dazunehmen
    .hint = Noch ein Körper läuft mit
race-leave = Verlassen
    .hint = Das Rennen verlassen; dieser Körper läuft allein weiter
race-go = Los!
race-begins = Wettrennen gegen { $names }. { $start }.
race-left = Das Rennen ist verlassen
race-own = { $name } (deiner)
race-other = { $name } (der andere)
race-yours = Deiner

race-at-start = Am Start
race-so-far = { $verdict }, nach { $seconds } s
race-unfair = { $verdict }; unterwegs verändert oder bewegt
race-ahead = { $own ->
    [yes] Deiner liegt vorn
   *[no] { $name } liegt vorn
}
race-ahead-by = { $own ->
    [yes] Deiner liegt { $distance } vorn
   *[no] { $name } liegt { $distance } vorn
}
race-close = Keiner von beiden liegt vorn
    .many = Keiner liegt vorn
race-is-first = { $own ->
    [yes] Deiner ist Erster, nach { $seconds } s
   *[no] { $name } ist Erster, nach { $seconds } s
}
race-was-first = { $own ->
    [yes] Deiner war Erster, nach { $seconds } s
   *[no] { $name } war Erster, nach { $seconds } s
}
race-alone = { $own ->
    [yes] Deiner war Erster; { $fates }
   *[no] { $name } war Erster; { $fates }
}
race-won = { $own ->
    [yes] Deiner war Erster, mit { $seconds } s Vorsprung
   *[no] { $name } war Erster, mit { $seconds } s Vorsprung
}
race-won-before = { $own ->
    [yes] Deiner war Erster, { $seconds } s vor { $next }
   *[no] { $name } war Erster, { $seconds } s vor { $nextOwn ->
        [yes] deinem
       *[no] { $next }
    }
}
race-both = Beide gleichzeitig, nach { $seconds } s
race-several = { $names } gleichzeitig, nach { $seconds } s
race-nobody = Keiner war Erster: { $fates }
race-exploded = { $who ->
    [first] Deiner ist explodiert
    [own] deiner ist explodiert
    [both] beide sind explodiert
    [all] alle sind explodiert
   *[other] { $name } ist explodiert
}
race-fell = { $who ->
    [first] Deiner ist abgestürzt
    [own] deiner ist abgestürzt
    [both] beide sind abgestürzt
    [all] alle sind abgestürzt
   *[other] { $name } ist abgestürzt
}
race-away = { $who ->
    [first] Deiner ist in die andere Richtung gelaufen
    [own] deiner ist in die andere Richtung gelaufen
    [both] beide sind in die andere Richtung gelaufen
    [all] alle sind in die andere Richtung gelaufen
   *[other] { $name } ist in die andere Richtung gelaufen
}
race-misfit = { $who ->
    [first] Deiner passt nicht auf dieses Gelände
    [own] deiner passt nicht auf dieses Gelände
    [both] beide passen nicht auf dieses Gelände
    [all] alle passen nicht auf dieses Gelände
   *[other] { $name } passt nicht auf dieses Gelände
}
race-late = { $who ->
    [first] Deiner hat mehr als { $limit } s gebraucht
    [own] deiner hat mehr als { $limit } s gebraucht
    [both] beide haben mehr als { $limit } s gebraucht
    [all] alle haben mehr als { $limit } s gebraucht
   *[other] { $name } hat mehr als { $limit } s gebraucht
}

race-finish = Ziel, { $way }
race-to = { $distance } voraus
    .behind = { $distance } zurück
race-named = { $name }, { $way }

race-full = mehr als { $count } Körper gehen nicht in ein Rennen
race-unknown = { $text } ist weder ein Link zu einer Szene noch der Name einer Szene
