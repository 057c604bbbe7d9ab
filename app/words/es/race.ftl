race-strip = Carrera
race-rule = Todos salen a la vez, en el terreno de este cuerpo, y en la meta cuenta el centro de cada uno. Se permiten cambios de este cuerpo y del terreno, y aquí se anotan; «Correr otra vez» la hace justa de nuevo.
race-choose = Carrera contra
    .paste = Pega un enlace, o elige abajo
    .link = Enlace a la escena contra la que correr
    .go = Correr
race-start = Salir
    .hint = Todos desde la salida, tras una cuenta atrás
    .again = Correr otra vez
race-add = Añadir
    .hint = Otro cuerpo se une a la carrera
race-leave = Abandonar
    .hint = Abandonar la carrera; este cuerpo sigue solo
race-go = ¡Ya!
race-begins = Una carrera contra { $names }. { $start }.
race-left = Has abandonado la carrera
race-own = { $name } (el tuyo)
race-other = { $name } (el otro)
race-yours = El tuyo

race-at-start = En la salida
race-so-far = { $verdict }, a los { $seconds } s
race-unfair = { $verdict }; cambiado o movido por el camino
race-ahead = { $own ->
    [yes] El tuyo va por delante
   *[no] { $name } va por delante
}
race-ahead-by = { $own ->
    [yes] El tuyo va { $distance } por delante
   *[no] { $name } va { $distance } por delante
}
race-close = Ninguno de los dos va por delante
    .many = Ninguno va por delante
race-is-first = { $own ->
    [yes] El tuyo llega en primer lugar, a los { $seconds } s
   *[no] { $name } llega en primer lugar, a los { $seconds } s
}
race-was-first = { $own ->
    [yes] El tuyo llegó en primer lugar, a los { $seconds } s
   *[no] { $name } llegó en primer lugar, a los { $seconds } s
}
race-alone = { $own ->
    [yes] El tuyo llegó en primer lugar; { $fates }
   *[no] { $name } llegó en primer lugar; { $fates }
}
race-won = { $own ->
    [yes] El tuyo llegó en primer lugar, con { $seconds } s de ventaja
   *[no] { $name } llegó en primer lugar, con { $seconds } s de ventaja
}
race-won-before = { $own ->
    [yes] El tuyo llegó en primer lugar, { $seconds } s antes que { $next }
   *[no] { $name } llegó en primer lugar, { $seconds } s antes que { $nextOwn ->
        [yes] el tuyo
       *[no] { $next }
    }
}
race-both = Los dos a la vez, a los { $seconds } s
race-several = { $names } a la vez, a los { $seconds } s
race-nobody = Nadie llegó en primer lugar: { $fates }
race-exploded = { $who ->
    [first] El tuyo ha explotado
    [own] el tuyo ha explotado
    [both] los dos han explotado
    [all] todos han explotado
   *[other] { $name } ha explotado
}
race-fell = { $who ->
    [first] El tuyo se ha caído
    [own] el tuyo se ha caído
    [both] los dos se han caído
    [all] todos se han caído
   *[other] { $name } se ha caído
}
race-away = { $who ->
    [first] El tuyo se ha ido en sentido contrario
    [own] el tuyo se ha ido en sentido contrario
    [both] los dos se han ido en sentido contrario
    [all] todos se han ido en sentido contrario
   *[other] { $name } se ha ido en sentido contrario
}
race-misfit = { $who ->
    [first] El tuyo no encaja en este terreno
    [own] el tuyo no encaja en este terreno
    [both] ninguno de los dos encaja en este terreno
    [all] ninguno encaja en este terreno
   *[other] { $name } no encaja en este terreno
}
race-late = { $who ->
    [first] El tuyo ha necesitado más de { $limit } s
    [own] el tuyo ha necesitado más de { $limit } s
    [both] los dos han necesitado más de { $limit } s
    [all] todos han necesitado más de { $limit } s
   *[other] { $name } ha necesitado más de { $limit } s
}

race-finish = Meta, { $way }
race-to = { $distance } por delante
    .behind = { $distance } por detrás
race-named = { $name }, { $way }

race-full = en una carrera caben como máximo { $count } cuerpos
race-unknown = { $text } no es un enlace a una escena ni el nombre de ninguna
