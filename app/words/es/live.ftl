live-picture = Esto es una imagen: aquí no se ejecutan scripts. Abre el archivo en un navegador web y se moverá.
live-too-old = Este navegador no puede mostrar el archivo; uno más nuevo sí.
live-play = Reproducir
live-pause = Pausar
live-speed = Velocidad

replay-again = Reproducir otra vez
replay-time = Instante mostrado
replay-too-old = Este navegador no puede reproducir el archivo; uno más nuevo sí.

live-exploded = El cuerpo ha explotado
live-back = Volver a antes de eso
live-side = Controles y números
live-lesson = Lección
live-others = Más deslizadores
live-answers = Entregar tus respuestas
live-step = +1 paso
live-time = Tiempo
live-reset = Reiniciar
live-follow = Seguir
    .hint = Seguir el puntero
live-view = Vista y teclas

live-arrow-left = Izquierda: ángulos naturales menores
    .works = Izquierda: { $work }
live-arrow-up = Arriba: más largos
    .works = Arriba: { $work }
live-arrow-down = Abajo: más cortos
    .works = Abajo: { $work }
live-arrow-right = Derecha: ángulos naturales mayores
    .works = Derecha: { $work }
live-work-motors = girar los motores
live-work-muscles = accionar los músculos
live-work-forces = empujar masas

live-notes = En este archivo { $notes }.
live-note-verlet = el cuerpo se mueve con el método de Verlet con velocidades, sin control del error
live-note-shape = la forma del cuerpo no se puede cambiar
live-note-sliders = no hay deslizador para { $settings }
live-note-controls = la lección no tiene ningún control para { $settings }
live-note-plots = faltan las gráficas de { $quantities }
live-note-ghost = no hay un segundo cuerpo con el que comparar
live-note-arrows = no hay flechas
live-note-goals = algunos objetivos no se evalúan
live-note-runs = no se entrega ninguna simulación

live-stopped = detenido
live-paused = en pausa
live-slowed = ralentizado: { $rate } × tiempo real
live-broken = { $count ->
    [one] { $count } resorte roto
   *[other] { $count } resortes rotos
}
live-yielded = { $count ->
    [one] { $count } resorte con deformación permanente
   *[other] { $count } resortes con deformación permanente
}
live-limit = paso de tiempo { $step } ms, { $part } % del límite
    .over = paso de tiempo { $step } ms, { $part } % del límite: inestable

live-joint = Articulación { $joint }
    .angle = ángulo
    .rest = ángulo natural
    .sine = seno
    .cosine = coseno
live-energy = Energía, { $unit }
    .kinetic = cinética
    .height = altura
    .linear = lineal
    .angular = angular

live-cause =
    .linear = El paso de tiempo de { $step } s está por encima del límite de estabilidad de { $limit } s, que marcan los resortes lineales.
    .angular = El paso de tiempo de { $step } s está por encima del límite de estabilidad de { $limit } s, que marcan los resortes angulares.
    .small = El paso de tiempo está por debajo del límite de estabilidad, pero ese límite es para movimientos pequeños; el cuerpo se ha movido o preparado con demasiada violencia.
    .violent = El cuerpo se ha movido o preparado con demasiada violencia.

live-downwards = { $quantity }, hacia abajo
live-over = en función de { $quantity }
live-swing = { $reading }, periodo { $period } s, amplitud { $amplitude }
live-swings = Periodos { $periods } s; amplitudes { $amplitudes }
live-at = En { $time } s: { $readings }

live-own-words = Con tus propias palabras:
live-predict = Mueve las masas hasta donde estarán después de { $time } s. Luego pulsa el botón.
    .done = Estará ahí
    .seen = La línea fina es tu predicción para { $time } s.
live-goal = Objetivo: { $goal }.
    .now = Objetivo: { $goal }. Ahora: { $reading }.
    .reached = Alcanzado: { $goal }.

live-leaves = Nada sale de este archivo por sí solo. Entrega el archivo a tu docente o muestra el código QR.
live-name = Tu nombre o apodo, si tu docente lo pide:
live-save = Guardar las respuestas en un archivo
live-qr = Código QR de las respuestas
    .text = El código QR es el texto de debajo, de { $letters } caracteres.
    .left = El código QR es el texto de debajo, de { $letters } caracteres. En él no cabe { $left }; en el archivo está todo.
live-left-prediction = la predicción del paso { $step }
live-left-line = la frase del paso { $step }
    .end = el final de la frase del paso { $step }

live-dark = Oscuro
live-larger = Más grande, para un proyector
live-keys-drag = la masa queda sujeta mientras la arrastras; varios dedos arrastran varias
    .keys = arrastrar
live-keys-play = reproducir o pausar
    .keys = Espacio
live-keys-step = un paso
live-keys-reset = reiniciar: el cuerpo empieza de nuevo, con los deslizadores como están
live-keys-follow = la masa con el anillo sigue el puntero, o deja de seguirlo
live-keys-longer = los resortes se alargan o se acortan
    .keys = mantener ↑ ↓
live-keys-bent = los ángulos naturales aumentan o disminuyen
    .keys = mantener → ←
live-keys-motors = los motores giran, hacia delante y hacia atrás
    .keys = mantener flechas
live-keys-dark = oscuro o blanco; más grande, para un proyector
live-keys-body = ir al cuerpo: allí las flechas eligen una masa, Espacio la agarra y las flechas la mueven
    .keys = Tab
live-keys-help = esta ayuda

live-sheet-title = { $lesson }: para el profesorado
live-sheet-needs = Unos { $minutes } minutos. Hacen falta un equipo con proyector y un teléfono, una tableta o un equipo por cada estudiante o cada dos. Se empieza con { $command }; { $next } lleva de una fase a otra.
live-sheet-next = Siguiente
live-sheet-how = Preguntar: todos responden sin ver las demás respuestas. No decir cuál es la correcta. Con menos del 35 % de aciertos, volver a explicarlo; hasta el 70 %, dejar que hablen en parejas y preguntar otra vez. Ponerlo en marcha, revelar la solución y pedirles que escriban en una frase por qué; después experimentan y entregan.
live-sheet-ask = Preguntar
live-sheet-predict = Predecir
    .text = Cada estudiante arrastra el cuerpo pálido hasta donde estará después de { $time } s.
live-sheet-run = Poner en marcha
live-sheet-reveal = Revelar
live-sheet-try = Experimentar
live-sheet-watch = Observar
live-sheet-goal = Objetivo
    .text = { $goal }.
live-sheet-collect = Recoger
    .text = { $reading }.
