describe-mass = { $count ->
    [one] Eine einzelne Masse.
   *[other] { $count } einzelne Massen.
}
describe-chain = { $count ->
    [one] Eine Kette aus { $masses } Massen mit { $springs ->
        [one] einer Feder
       *[other] { $springs } Federn
    } und { $joints ->
        [0] keinen Gelenken
        [one] einem Gelenk
       *[other] { $joints } Gelenken
    }.
   *[other] { $count } Ketten aus je { $masses } Massen mit { $springs ->
        [one] einer Feder
       *[other] { $springs } Federn
    } und { $joints ->
        [0] keinen Gelenken
        [one] einem Gelenk
       *[other] { $joints } Gelenken
    }.
}
describe-ring = { $count ->
    [one] Ein Ring aus { $masses } Massen mit { $springs ->
        [one] einer Feder
       *[other] { $springs } Federn
    } und { $joints ->
        [0] keinen Gelenken
        [one] einem Gelenk
       *[other] { $joints } Gelenken
    }.
   *[other] { $count } Ringe aus je { $masses } Massen mit { $springs ->
        [one] einer Feder
       *[other] { $springs } Federn
    } und { $joints ->
        [0] keinen Gelenken
        [one] einem Gelenk
       *[other] { $joints } Gelenken
    }.
}
describe-tree = { $count ->
    [one] Ein Baum aus { $masses } Massen mit { $springs ->
        [one] einer Feder
       *[other] { $springs } Federn
    } und { $joints ->
        [0] keinen Gelenken
        [one] einem Gelenk
       *[other] { $joints } Gelenken
    }.
   *[other] { $count } Bäume aus je { $masses } Massen mit { $springs ->
        [one] einer Feder
       *[other] { $springs } Federn
    } und { $joints ->
        [0] keinen Gelenken
        [one] einem Gelenk
       *[other] { $joints } Gelenken
    }.
}
describe-net = { $count ->
    [one] Ein Netz aus { $masses } Massen mit { $springs ->
        [one] einer Feder
       *[other] { $springs } Federn
    } in { $loops ->
        [one] einer Masche
       *[other] { $loops } Maschen
    } und { $joints ->
        [0] keinen Gelenken
        [one] einem Gelenk
       *[other] { $joints } Gelenken
    }.
   *[other] { $count } Netze aus je { $masses } Massen mit { $springs ->
        [one] einer Feder
       *[other] { $springs } Federn
    } in { $loops ->
        [one] einer Masche
       *[other] { $loops } Maschen
    } und { $joints ->
        [0] keinen Gelenken
        [one] einem Gelenk
       *[other] { $joints } Gelenken
    }.
}

describe-free = Nichts hält den Körper fest.
    .parts = { $count ->
        [one] Nichts hält dieses Teil fest.
       *[other] Nichts hält sie fest.
    }
describe-held = Festgehalten ist Masse { $mass }, { $side ->
    [left] am linken Ende
    [right] am rechten Ende
    [top] oben
    [bottom] unten
    [leftTop] links oben
    [rightTop] rechts oben
    [leftBottom] links unten
    [rightBottom] rechts unten
   *[inside] zwischen den Enden
}.
    .mass = Masse { $mass } ist festgehalten.
describe-held-many = { $count } Massen sind festgehalten: { $masses }.
describe-held-most = { $count } Massen sind festgehalten.

describe-lies = Der Körper ist { $width } breit und { $height } hoch.
    .all = Alles zusammen ist { $width } breit und { $height } hoch.
describe-piece = Körper { $number } von { $side ->
    [top] oben
   *[left] links
} besteht aus { $count ->
    [one] der Masse
   *[other] den Massen
} { $masses }.
describe-hangs = Seine tiefste Masse, { $mass }, liegt { $depth } unter der höchsten festgehaltenen.

describe-still = Er ist in Ruhe.
    .away = Er bewegt sich gerade nicht, { $length } von seiner Ruhelage entfernt.
    .nearly = Er ist fast in Ruhe: Er schwingt um weniger als { $length }.
    .all = Nichts bewegt sich.
describe-moves = Seine schnellste Masse, { $mass }, bewegt sich { $way } mit { $speed }.
    .all = Die schnellste Masse, { $mass }, bewegt sich { $way } mit { $speed }.
describe-drifts = Als Ganzes bewegt er sich { $whole } mit { $speed }.
describe-turns = Er dreht sich { $sense ->
    [clockwise] im Uhrzeigersinn
   *[counterclockwise] gegen den Uhrzeigersinn
} um { $degrees } Grad in der Sekunde.
describe-way = { $way ->
    [right] nach rechts
    [upRight] nach rechts oben
    [up] nach oben
    [upLeft] nach links oben
    [left] nach links
    [downLeft] nach links unten
    [down] nach unten
   *[downRight] nach rechts unten
}

describe-stretched = Feder { $spring } ist am stärksten gedehnt, um { $percent } %.
describe-squeezed = Feder { $spring } ist am stärksten gestaucht, um { $percent } %.
describe-touching = { $count ->
    [one] Eine Masse berührt etwas.
   *[other] { $count } Massen berühren etwas.
}
describe-broken = { $count ->
    [one] Eine Feder ist gerissen.
   *[other] { $count } Federn sind gerissen.
}
describe-yielded = { $count ->
    [one] Eine Feder oder ein Gelenk hat sich bleibend verformt.
   *[other] { $count } Federn und Gelenke haben sich bleibend verformt.
}

describe-swings = Sich selbst überlassen schwingt er einmal in { $period } Sekunden und verliert { $percent } % bei jeder Schwingung.
describe-swings-on = Sich selbst überlassen schwingt er einmal in { $period } Sekunden und verliert dabei fast nichts.

describe-same = Seitdem hat sich nichts verändert.
describe-moved = Seitdem hat er sich { $way } bewegt, um { $length }.
describe-broke = { $count ->
    [one] Seitdem ist eine Feder gerissen.
   *[other] Seitdem sind { $count } Federn gerissen.
}
describe-built = Seitdem wurde er umgebaut.

describe-part-mass = Masse { $mass }, { $weight }, ist bei x = { $x }, y = { $y }.
describe-part-held = Sie ist festgehalten.
    .hand = Du hältst sie in der Hand.
describe-part-still = Sie ist in Ruhe.
describe-part-moves = Sie bewegt sich { $way } mit { $speed }.
describe-part-alone = Keine Feder ist an ihr befestigt.
describe-part-joined = { $count ->
    [one] Feder { $springs } verbindet sie mit Masse { $masses }.
   *[other] Die Federn { $springs } verbinden sie mit den Massen { $masses }.
}
describe-part-joined-most = { $count ->
    [one] { $count } Feder verbindet sie mit einer anderen Masse.
   *[other] { $count } Federn verbinden sie mit anderen Massen.
}
describe-part-touches = Sie berührt etwas.
describe-part-spring = Feder { $spring } verbindet die Massen { $one } und { $other }.
describe-part-length = Ihre Länge ist { $length }, ihre Ruhelänge { $rest }.
describe-part-strain = Sie ist um { $percent } % { $sense ->
    [stretched] gedehnt
   *[squeezed] gestaucht
}.
describe-part-force = Sie { $sense ->
    [pulls] zieht ihre Enden mit { $force } zusammen
   *[pushes] drückt ihre Enden mit { $force } auseinander
}.
describe-part-broken = Gerissen.
describe-part-yielded = Bleibend verformt.
describe-part-muscle = Sie ist ein Muskel, der ihre Ruhelänge um bis zu { $percent } % verändert.
describe-part-joint = Gelenk { $joint } ist an Masse { $mass }, zwischen den Federn { $one } und { $other }.
describe-part-corner = Die Ecke zwischen diesen Federn hat { $corner }.
describe-part-angle = Sein Winkel ist { $angle }, sein Ruhewinkel { $rest }.
describe-part-torque = Sein Drehmoment ist { $torque }.
describe-part-bends = Es ist ein Muskel, der seinen Ruhewinkel um bis zu { $degrees } verändert.
describe-part-motor = Ein Motor dreht es mit bis zu { $speed }.

news-broke = { $count ->
    [one] Eine Feder ist gerissen.
   *[other] { $count } Federn sind gerissen.
}
news-touched = { $by ->
    [floor] Der Körper berührt den Boden.
    [wall] Der Körper berührt eine Wand.
   *[body] Der Körper berührt einen anderen oder sich selbst.
}
news-rest = Der Körper ist zur Ruhe gekommen.
news-exploded = Der Körper ist explodiert und angehalten.
news-grabbed = Masse { $mass } ist in der Hand.
news-dropped = Masse { $mass } ist losgelassen.
news-running = Läuft.
    .paused = Pause.
news-step = Schritt { $number }: { $title }

describe-title = Beschreibung
describe-close = Beschreibung schließen
