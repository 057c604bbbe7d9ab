describe-mass = { $count ->
    [one] Una sola masa.
   *[other] { $count } masas sueltas.
}
describe-chain = { $count ->
    [one] Una cadena de { $masses } masas, con { $springs ->
        [one] un resorte
       *[other] { $springs } resortes
    } y { $joints ->
        [0] sin articulaciones
        [one] una articulación
       *[other] { $joints } articulaciones
    }.
   *[other] { $count } cadenas de { $masses } masas, cada una con { $springs ->
        [one] un resorte
       *[other] { $springs } resortes
    } y { $joints ->
        [0] sin articulaciones
        [one] una articulación
       *[other] { $joints } articulaciones
    }.
}
describe-ring = { $count ->
    [one] Un anillo de { $masses } masas, con { $springs ->
        [one] un resorte
       *[other] { $springs } resortes
    } y { $joints ->
        [0] sin articulaciones
        [one] una articulación
       *[other] { $joints } articulaciones
    }.
   *[other] { $count } anillos de { $masses } masas, cada uno con { $springs ->
        [one] un resorte
       *[other] { $springs } resortes
    } y { $joints ->
        [0] sin articulaciones
        [one] una articulación
       *[other] { $joints } articulaciones
    }.
}
describe-tree = { $count ->
    [one] Un árbol de { $masses } masas, con { $springs ->
        [one] un resorte
       *[other] { $springs } resortes
    } y { $joints ->
        [0] sin articulaciones
        [one] una articulación
       *[other] { $joints } articulaciones
    }.
   *[other] { $count } árboles de { $masses } masas, cada uno con { $springs ->
        [one] un resorte
       *[other] { $springs } resortes
    } y { $joints ->
        [0] sin articulaciones
        [one] una articulación
       *[other] { $joints } articulaciones
    }.
}
describe-net = { $count ->
    [one] Una red de { $masses } masas, con { $springs ->
        [one] un resorte
       *[other] { $springs } resortes
    } en { $loops ->
        [one] una malla
       *[other] { $loops } mallas
    } y { $joints ->
        [0] sin articulaciones
        [one] una articulación
       *[other] { $joints } articulaciones
    }.
   *[other] { $count } redes de { $masses } masas, cada una con { $springs ->
        [one] un resorte
       *[other] { $springs } resortes
    } en { $loops ->
        [one] una malla
       *[other] { $loops } mallas
    } y { $joints ->
        [0] sin articulaciones
        [one] una articulación
       *[other] { $joints } articulaciones
    }.
}

describe-free = Nada lo sujeta.
    .parts = { $count ->
        [one] Nada sujeta esta parte.
       *[other] Nada las sujeta.
    }
describe-held = Está fija la masa { $mass }, { $side ->
    [left] en su extremo izquierdo
    [right] en su extremo derecho
    [top] en lo alto
    [bottom] en lo más bajo
    [leftTop] arriba a la izquierda
    [rightTop] arriba a la derecha
    [leftBottom] abajo a la izquierda
    [rightBottom] abajo a la derecha
   *[inside] entre sus extremos
}.
    .mass = La masa { $mass } está fija.
describe-held-many = Hay { $count } masas fijas: { $masses }.
describe-held-most = Hay { $count } masas fijas.

describe-lies = Mide { $width } de ancho y { $height } de alto.
    .all = Todo junto mide { $width } de ancho y { $height } de alto.
describe-piece = El cuerpo { $number } desde { $side ->
    [top] arriba
   *[left] la izquierda
} consta de { $count ->
    [one] la masa
   *[other] las masas
} { $masses }.
describe-hangs = Su masa más baja, la { $mass }, está { $depth } por debajo de la masa fija más alta.

describe-still = Está en reposo.
    .away = Ahora no se mueve, a { $length } de su reposo.
    .nearly = Está casi en reposo: oscila menos de { $length }.
    .all = Nada se mueve.
describe-moves = Su masa más rápida, la { $mass }, se mueve { $way } a { $speed }.
    .all = La masa más rápida, la { $mass }, se mueve { $way } a { $speed }.
describe-drifts = En conjunto se mueve { $whole } a { $speed }.
describe-turns = Gira { $sense ->
    [clockwise] en sentido horario
   *[counterclockwise] en sentido antihorario
} { $degrees } grados por segundo.
describe-way = { $way ->
    [right] hacia la derecha
    [upRight] hacia arriba a la derecha
    [up] hacia arriba
    [upLeft] hacia arriba a la izquierda
    [left] hacia la izquierda
    [downLeft] hacia abajo a la izquierda
    [down] hacia abajo
   *[downRight] hacia abajo a la derecha
}

describe-stretched = El resorte { $spring } es el más estirado, un { $percent } %.
describe-squeezed = El resorte { $spring } es el más comprimido, un { $percent } %.
describe-touching = { $count ->
    [one] Una masa toca algo.
   *[other] { $count } masas tocan algo.
}
describe-broken = { $count ->
    [one] Hay un resorte roto.
   *[other] Hay { $count } resortes rotos.
}
describe-yielded = { $count ->
    [one] Un resorte o una articulación tiene una deformación permanente.
   *[other] { $count } resortes y articulaciones tienen una deformación permanente.
}

describe-swings = Por sí solo, hace una oscilación cada { $period } segundos y pierde un { $percent } % en cada una.
describe-swings-on = Por sí solo, hace una oscilación cada { $period } segundos y apenas pierde nada.

describe-same = Desde entonces no ha cambiado nada.
describe-moved = Desde entonces se ha movido { $length } { $way }.
describe-broke = { $count ->
    [one] Desde entonces se ha roto un resorte.
   *[other] Desde entonces se han roto { $count } resortes.
}
describe-built = Desde entonces se ha modificado.

describe-part-mass = La masa { $mass }, de { $weight }, está en x = { $x }, y = { $y }.
describe-part-held = Está fija.
    .hand = La tienes en la mano.
describe-part-still = Está en reposo.
describe-part-moves = Se mueve { $way } a { $speed }.
describe-part-alone = No tiene ningún resorte unido.
describe-part-joined = { $count ->
    [one] El resorte { $springs } la une a la masa { $masses }.
   *[other] Los resortes { $springs } la unen a las masas { $masses }.
}
describe-part-joined-most = { $count ->
    [one] { $count } resorte la une a otra masa.
   *[other] { $count } resortes la unen a otras masas.
}
describe-part-touches = Toca algo.
describe-part-spring = El resorte { $spring } une las masas { $one } y { $other }.
describe-part-length = Mide { $length }; su longitud natural es de { $rest }.
describe-part-strain = Está { $sense ->
    [stretched] estirado
   *[squeezed] comprimido
} un { $percent } %.
describe-part-force = { $sense ->
    [pulls] Acerca sus extremos
   *[pushes] Separa sus extremos
} con una fuerza de { $force }.
describe-part-broken = Se ha roto.
describe-part-yielded = Tiene una deformación permanente.
describe-part-muscle = Es un músculo que cambia su longitud natural hasta un { $percent } %.
describe-part-joint = La articulación { $joint } está en la masa { $mass }, entre los resortes { $one } y { $other }.
describe-part-corner = La esquina entre estos resortes mide { $corner }.
describe-part-angle = Su ángulo es de { $angle }; su ángulo natural, de { $rest }.
describe-part-torque = Su momento es de { $torque }.
describe-part-bends = Es un músculo que cambia su ángulo natural hasta { $degrees }.
describe-part-motor = Un motor la hace girar a { $speed } como máximo.

news-broke = { $count ->
    [one] Se ha roto un resorte.
   *[other] Se han roto { $count } resortes.
}
news-touched = { $by ->
    [floor] El cuerpo toca el suelo.
    [wall] El cuerpo toca una pared.
   *[body] El cuerpo toca otro cuerpo o a sí mismo.
}
news-rest = El cuerpo ha quedado en reposo.
news-exploded = El cuerpo ha explotado y se ha detenido.
news-grabbed = La masa { $mass } está en la mano.
news-dropped = Se ha soltado la masa { $mass }.
news-running = En marcha.
    .paused = En pausa.
news-step = Paso { $number }: { $title }

describe-title = Descripción
describe-close = Cerrar la descripción
