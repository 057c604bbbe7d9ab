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
describe-held-many = { $count } Massen sind festgehalten: { $masses }.
describe-held-most = { $count } Massen sind festgehalten.

describe-lies = Der Körper ist { $width } breit und { $height } hoch.
describe-hangs = Seine tiefste Masse, { $mass }, liegt { $depth } unter der höchsten festgehaltenen.

describe-still = Er ist in Ruhe.
describe-moves = Seine schnellste Masse, { $mass }, bewegt sich { $way } mit { $speed }.
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

describe-title = Beschreibung
describe-close = Beschreibung schließen
