describe-mass = { $count ->
    [one] Une masse isolée.
   *[other] { $count } masses isolées.
}
describe-chain = { $count ->
    [one] Une chaîne de { $masses } masses, avec { $springs ->
        [one] un ressort
       *[other] { $springs } ressorts
    } et { $joints ->
        [0] sans articulation
        [one] une articulation
       *[other] { $joints } articulations
    }.
   *[other] { $count } chaînes de { $masses } masses, avec pour chacune { $springs ->
        [one] un ressort
       *[other] { $springs } ressorts
    } et { $joints ->
        [0] sans articulation
        [one] une articulation
       *[other] { $joints } articulations
    }.
}
describe-ring = { $count ->
    [one] Un anneau de { $masses } masses, avec { $springs ->
        [one] un ressort
       *[other] { $springs } ressorts
    } et { $joints ->
        [0] sans articulation
        [one] une articulation
       *[other] { $joints } articulations
    }.
   *[other] { $count } anneaux de { $masses } masses, avec pour chacun { $springs ->
        [one] un ressort
       *[other] { $springs } ressorts
    } et { $joints ->
        [0] sans articulation
        [one] une articulation
       *[other] { $joints } articulations
    }.
}
describe-tree = { $count ->
    [one] Un arbre de { $masses } masses, avec { $springs ->
        [one] un ressort
       *[other] { $springs } ressorts
    } et { $joints ->
        [0] sans articulation
        [one] une articulation
       *[other] { $joints } articulations
    }.
   *[other] { $count } arbres de { $masses } masses, avec pour chacun { $springs ->
        [one] un ressort
       *[other] { $springs } ressorts
    } et { $joints ->
        [0] sans articulation
        [one] une articulation
       *[other] { $joints } articulations
    }.
}
describe-net = { $count ->
    [one] Un filet de { $masses } masses, avec { $springs ->
        [one] un ressort
       *[other] { $springs } ressorts
    } en { $loops ->
        [one] une seule maille
       *[other] { $loops } mailles
    } et { $joints ->
        [0] sans articulation
        [one] une articulation
       *[other] { $joints } articulations
    }.
   *[other] { $count } filets de { $masses } masses, avec pour chacun { $springs ->
        [one] un ressort
       *[other] { $springs } ressorts
    } en { $loops ->
        [one] une seule maille
       *[other] { $loops } mailles
    } et { $joints ->
        [0] sans articulation
        [one] une articulation
       *[other] { $joints } articulations
    }.
}

describe-free = Rien ne tient l’objet.
    .parts = { $count ->
        [one] Rien ne tient cette partie.
       *[other] Rien ne les tient.
    }
describe-held = L’objet est fixé à la masse { $mass }, { $side ->
    [left] à son extrémité gauche
    [right] à son extrémité droite
    [top] en haut
    [bottom] en bas
    [leftTop] en haut à gauche
    [rightTop] en haut à droite
    [leftBottom] en bas à gauche
    [rightBottom] en bas à droite
   *[inside] entre ses extrémités
}.
    .mass = La masse { $mass } est fixée.
describe-held-many = { $count } masses sont fixées : { $masses }.
describe-held-most = { $count } masses sont fixées.

describe-lies = L’objet mesure { $width } de large et { $height } de haut.
    .all = Le tout mesure { $width } de large et { $height } de haut.
describe-piece = L’objet { $number } en partant { $side ->
    [top] du haut
   *[left] de la gauche
} est fait { $count ->
    [one] de la masse
   *[other] des masses
} { $masses }.
describe-hangs = La masse { $mass }, la plus basse, est { $depth } plus bas que la plus haute des masses fixées.

describe-still = L’objet est au repos.
    .away = L’objet ne bouge pas en ce moment, à { $length } de son repos.
    .nearly = L’objet est presque au repos : il oscille de moins de { $length }.
    .all = Rien ne bouge.
describe-moves = La masse { $mass }, la plus rapide, se déplace { $way } à { $speed }.
    .all = La masse { $mass }, la plus rapide de toutes, se déplace { $way } à { $speed }.
describe-drifts = Dans l’ensemble, l’objet se déplace { $whole } à { $speed }.
describe-turns = Il tourne { $sense ->
    [clockwise] dans le sens des aiguilles d’une montre
   *[counterclockwise] dans le sens inverse des aiguilles d’une montre
}, de { $degrees } degrés par seconde.
describe-way = { $way ->
    [right] vers la droite
    [upRight] vers le haut et la droite
    [up] vers le haut
    [upLeft] vers le haut et la gauche
    [left] vers la gauche
    [downLeft] vers le bas et la gauche
    [down] vers le bas
   *[downRight] vers le bas et la droite
}

describe-stretched = Le ressort { $spring } est le plus étiré, de { $percent } %.
describe-squeezed = Le ressort { $spring } est le plus comprimé, de { $percent } %.
describe-touching = { $count ->
    [one] Une masse touche quelque chose.
   *[other] { $count } masses touchent quelque chose.
}
describe-broken = { $count ->
    [one] Un ressort est cassé.
   *[other] { $count } ressorts sont cassés.
}
describe-yielded = { $count ->
    [one] Un ressort ou une articulation garde une déformation permanente.
   *[other] { $count } ressorts et articulations gardent une déformation permanente.
}

describe-swings = Laissé à lui-même, l’objet fait une oscillation en { $period } secondes et perd { $percent } % à chaque oscillation.
describe-swings-on = Laissé à lui-même, l’objet fait une oscillation en { $period } secondes et ne perd presque rien.

describe-same = Rien n’a changé depuis.
describe-moved = Depuis, l’objet s’est déplacé { $way } de { $length }.
describe-broke = { $count ->
    [one] Depuis, un ressort s’est cassé.
   *[other] Depuis, { $count } ressorts se sont cassés.
}
describe-built = Depuis, l’objet a été modifié.

describe-part-mass = La masse { $mass }, de { $weight }, est en x = { $x }, y = { $y }.
describe-part-held = Elle est fixée.
    .hand = Tu la tiens dans la main.
describe-part-still = Elle est au repos.
describe-part-moves = Elle se déplace { $way } à { $speed }.
describe-part-alone = Aucun ressort n’y est attaché.
describe-part-joined = { $count ->
    [one] Le ressort { $springs } la relie à la masse { $masses }.
   *[other] Les ressorts { $springs } la relient aux masses { $masses }.
}
describe-part-joined-most = { $count ->
    [one] { $count } ressort la relie à une autre masse.
   *[other] { $count } ressorts la relient à d’autres masses.
}
describe-part-touches = Elle touche quelque chose.
describe-part-spring = Le ressort { $spring } relie les masses { $one } et { $other }.
describe-part-length = Sa longueur est de { $length } ; sa longueur à vide, de { $rest }.
describe-part-strain = Il est { $sense ->
    [stretched] étiré
   *[squeezed] comprimé
} de { $percent } %.
describe-part-force = Il { $sense ->
    [pulls] rapproche ses extrémités
   *[pushes] écarte ses extrémités
} avec une force de { $force }.
describe-part-broken = Il y a eu rupture.
describe-part-yielded = La déformation est permanente.
describe-part-muscle = C’est un muscle, qui fait varier sa longueur à vide de { $percent } % au plus.
describe-part-joint = L’articulation { $joint } se trouve à la masse { $mass }, entre les ressorts { $one } et { $other }.
describe-part-corner = Le coin entre ces ressorts fait { $corner }.
describe-part-angle = Son angle est de { $angle } ; son angle au repos, de { $rest }.
describe-part-torque = Son couple est de { $torque }.
describe-part-bends = C’est un muscle, qui fait varier son angle au repos de { $degrees } au plus.
describe-part-motor = Un moteur la fait tourner à { $speed } au plus.

news-broke = { $count ->
    [one] Un ressort s’est cassé.
   *[other] { $count } ressorts se sont cassés.
}
news-touched = { $by ->
    [floor] L’objet touche le sol.
    [wall] L’objet touche un mur.
   *[body] L’objet touche un autre objet ou lui-même.
}
news-rest = L’objet s’est arrêté.
news-exploded = L’objet a explosé ; la simulation est arrêtée.
news-grabbed = La masse { $mass } est en main.
news-dropped = La masse { $mass } est lâchée.
news-running = En mouvement.
    .paused = En pause.
news-step = Étape { $number } : { $title }

describe-title = Description
describe-close = Fermer la description
