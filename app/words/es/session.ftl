session-cannot = Eso no se puede hacer
session-busy = la escena está ocupada; inténtalo de nuevo
session-not-resumed = no se ha podido reanudar: { $why }

session-exploded = El cuerpo ha explotado
    .setting = El paso de tiempo de { $step } s está por encima del límite de estabilidad de { $limit } s con { $setting } { $value }. Se muestra el último estado bueno. Vuelve a justo antes, reduce uno de los dos y sigue; o pulsa «Reiniciar».
    .part = El paso de tiempo de { $step } s está por encima del límite de estabilidad de { $limit } s con la rigidez de esto: { $part }. Se muestra el último estado bueno. Vuelve a justo antes, redúcela o elige el método de cálculo «Automático», y sigue; o pulsa «Reiniciar».
    .otherwise = Detenido antes del paso { $step }: { $what }; { $why }. Se muestra el último estado bueno. Vuelve a justo antes, { $remedy }, y sigue; o pulsa «Reiniciar».
session-what-number = la masa { $mass } tendría una posición o una velocidad que no es un número finito
session-what-position = la masa { $mass } ha llegado demasiado lejos (más de { $limit } px)
session-what-step = ningún paso desde aquí es lo bastante corto
session-what-speed = la masa { $mass } ha llegado a ser demasiado rápida (más de { $limit } px/s)
session-why-law = la ley de fuerza del tutorial no tiene energía y puede mover un cuerpo cada vez más deprisa
session-why-violent = el cuerpo se ha movido o preparado con demasiada violencia
session-why-violent-step = el cuerpo se ha movido o preparado con demasiada violencia para este paso de tiempo
session-why-small = el paso de tiempo está por debajo del límite de estabilidad, pero ese límite es para movimientos pequeños alrededor de una postura; los grandes o rápidos pueden superarlo
session-why-small-law = el paso de tiempo está por debajo del límite de estabilidad, pero ese límite es para movimientos pequeños alrededor de una postura; los grandes o rápidos pueden superarlo, y la ley de fuerza del tutorial no tiene energía y puede mover un cuerpo cada vez más deprisa
session-remedy-law = muévelo con más suavidad, aumenta el amortiguamiento o elige otra ley de fuerza
session-remedy-gently = muévelo con más suavidad o aumenta el amortiguamiento
session-remedy-step = reduce el paso de tiempo, elige el método de cálculo «Automático», aumenta el amortiguamiento o muévelo con más suavidad
session-cause-linear-stiffness = rigidez al estirar
session-cause-linear-damping = amortiguamiento al estirar
session-cause-angular-stiffness = rigidez al doblar
session-cause-angular-damping = amortiguamiento al doblar
session-cause-air-friction = fricción del aire
session-cause-one-sided = resortes de un solo sentido
session-cause-resistance = resistencia
session-cause-walls = paredes
session-cause-fillings = gases y líquidos
session-cause-contact = contacto
session-cause-motors = motores
session-cause-pushes = empujes
session-cause-rails = carriles

session-shape = Esta forma no se puede conservar
    .line = { $why } La línea muestra hacia dónde va.
    .button = { $why } El botón «Conservarla, rigidez × { $times }» lo consigue.
    .both = { $why } La línea muestra hacia dónde va. El botón «Conservarla, rigidez × { $times }» lo consigue.
    .text = { $why }

session-back-to = Volver a «{ $scene }»
    .undo = «Deshacer» lleva otra vez a «{ $scene }».
    .redo = «Rehacer» lleva otra vez a «{ $scene }».
session-opening = abrir { $scene }
session-own-body = valores originales del cuerpo
session-own-solver = valores originales del cálculo

session-replay-ended = La reproducción ha terminado
    .taken = Has tomado el mando de la reproducción.
    .stuck = No puede continuar: { $why }.
    .agrees = Coincide con el registro: { $verdict }.
    .differs = No coincide con el registro: { $verdict }.
session-replayed = { $checks ->
    [one] { $steps } pasos reproducidos; su comprobación coincide
   *[other] { $steps } pasos reproducidos; las { $checks } comprobaciones coinciden
}
    .digest = { $checks ->
    [one] { $steps } pasos reproducidos; su comprobación coincide, resumen { $digest }
   *[other] { $steps } pasos reproducidos; las { $checks } comprobaciones coinciden, resumen { $digest }
}
session-differs = difiere por primera vez en el paso { $step }, t = { $time } s (comprobación { $check } de { $checks }; coincide en el paso { $agreed }), { $how }
    .elsewhere = difiere por primera vez en el paso { $step }, t = { $time } s (comprobación { $check } de { $checks }; coincide en el paso { $agreed }), { $how }; se registró en { $machine }, esto es { $here }
session-differs-hidden = no en posiciones ni velocidades, sino en lo que hicieron las teclas, los daños o la fricción
session-differs-apart = distancia máxima de una masa anotada: { $distance }
session-differs-unknown = distancia máxima desconocida
session-too-heavy = este fotograma es demasiado pesado para reproducirlo en una página; `softrod run --inputs` puede hacerlo
session-log-plays = se está reproduciendo un registro; no hay nada más que guardar

session-awaited = se mueve con NumPy hasta que esté compilado: { $what }; { $ready } de { $count } partes listas
session-preparing = preparación ({ $what }): { $ready } de { $count } partes listas

session-errors-kept = Los errores no crecen: se cumple una tolerancia de { $tolerance }.
    .grow = Los errores crecen × { $factor } en un segundo: se cumple una tolerancia de { $tolerance }.
session-errors-step = Los errores no crecen: un paso de tiempo más corto los reduce.
    .grow = Los errores crecen × { $factor } en un segundo: un paso de tiempo más corto los reduce.
session-errors-lost = Los errores crecen × { $factor } en un segundo: ninguna tolerancia puede garantizar dónde estará dentro de { $seconds } s.
    .step = Los errores crecen × { $factor } en un segundo: ningún paso de tiempo puede garantizar dónde estará dentro de { $seconds } s.

session-plot-many = en una gráfica caben { $count } magnitudes
session-plot-units = en una gráfica caben dos unidades, pero no { $units }
session-mode-fast = el modo { $mode } tiene un periodo de { $period } s, menos de cuatro pasos de tiempo
