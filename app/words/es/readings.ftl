reading-stretch = alargamiento
reading-force = fuerza
reading-length = longitud
reading-angle = ángulo
reading-torque = momento de fuerza
reading-speed = rapidez
reading-vx = velocidad vx
reading-vy = velocidad vy
reading-momentum-x = cantidad de movimiento en x
reading-momentum-y = cantidad de movimiento en y
reading-distance = distancia
reading-time-step = paso de tiempo, como parte de su límite
reading-of = { $owner ->
    [mass] { $what } de la masa { $number }
    [spring] { $what } del resorte { $number }
    [joint] { $what } de la articulación { $number }
   *[body] { $what } del cuerpo
  }
reading-period = periodo ({ $what })
reading-period-of = { $owner ->
    [mass] periodo de la masa { $number }
    [spring] periodo del resorte { $number }
    [joint] periodo de la articulación { $number }
   *[body] periodo del cuerpo
  }

goal-between = { $reading }: de { $low } a { $high }
goal-least = { $reading }: como mínimo { $low }
goal-most = { $reading }: como máximo { $high }
goal-held = { $goal }, durante { $seconds } s

run-choice = { $choice }: { $option }
run-many = { $count ->
    [one] { $count } masa se desplaza hacia un lado y se suelta
   *[other] { $count } masas se desplazan hacia un lado y se sueltan
  }
run-pull = la masa { $mass } se desplaza { $way } y se suelta
run-way =
  .right = { $length } a la derecha
  .left = { $length } a la izquierda
  .down = { $length } hacia abajo
  .up = { $length } hacia arriba
run-ways = { $one } y { $other }
run-led = { $count ->
    [one] la masa { $masses } se lleva por una circunferencia de radio { $radius }, { $times } veces por segundo
   *[other] las masas { $masses } se llevan por una circunferencia de radio { $radius }, { $times } veces por segundo
  }
run-rests = { $count ->
    [one] el músculo de la articulación { $joints } descansa
   *[other] los músculos de las articulaciones { $joints } descansan
  }
run-muscles = { $count ->
    [one] un músculo se mueve en otro momento o con otro ángulo
   *[other] { $count } músculos se mueven en otro momento o con otro ángulo
  }
