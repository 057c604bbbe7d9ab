edit-tools = Edición
edit-bar = Lo seleccionado
edit-waits-build = Toca para poner una masa, arrastra para poner un resorte
edit-waits-joint = Toca una masa y después un ángulo en ella
edit-waits-select = Toca una parte, o arrastra alrededor de varias
edit-waits-cut = Arrastra a través de resortes
edit-paste = Pegar
edit-done = Listo
edit-rests = Lo movido, en reposo
    .hint = Los resortes y las articulaciones de lo que se mueve toman sus nuevas longitudes y sus nuevos ángulos como naturales, o conservan los de antes
edit-stiffen = Conservarla, rigidez × { $times }
edit-undo = Deshacer: { $what }
    .none = Nada que deshacer
    .done = Deshecho: { $what }
edit-redo = Rehacer: { $what }
    .none = Nada que rehacer
edit-masses = { $count ->
    [one] { $count } masa
   *[other] { $count } masas
}
edit-springs = { $count ->
    [one] { $count } resorte
   *[other] { $count } resortes
}
edit-joints = { $count ->
    [one] { $count } articulación
   *[other] { $count } articulaciones
}
edit-parts = { $count ->
    [one] { $count } parte
   *[other] { $count } partes
}
edit-mass = masa { $number }
edit-spring = resorte { $number }
edit-joint = articulación { $number }
edit-selected = Selección: { $parts }
    .none = Nada seleccionado
edit-open = Herramientas abiertas: { $tool }
    .closed = Herramientas cerradas
edit-begins = Un resorte empieza en la masa { $mass }: Intro en otra las une y sigue desde allí, Esc lo termina
    .ended = El resorte se ha abandonado
edit-cross = Cruz en { $place }. Las flechas la mueven, con Mayús una décima parte; Intro pulsa allí, Esc la quita
    .gone = La cruz ya no está
edit-cross-on = { $place }: { $part }
edit-rests-at = ángulo natural { $angle }
edit-moved = Masas movidas
    .text = Los resortes y las articulaciones de lo que has movido pueden quedar en reposo tal como están ahora, o conservar sus longitudes y ángulos naturales: entonces tiran hacia atrás en cuanto el reloj se pone en marcha.
    .take = Tomar las nuevas longitudes
    .keep = Conservar las longitudes naturales
    .once = Esto se pregunta una sola vez. El botón «Lo movido, en reposo» lo cambia.
edit-texts = Nombre y descripción de esta escena
    .name = Nombre
    .description = Qué muestra
    .done = Listo
    .cancel = Cancelar
edit-picture = Imagen
    .hint = Una imagen detrás del cuerpo, para dibujar encima; se queda en este navegador
    .size = Tamaño
    .opacity = Opacidad
    .move = Moverla
    .drag = Arrástrala, o usa las teclas de flecha, hasta pulsar Esc
    .another = Otra
    .remove = Quitarla
edit-no-picture = { $name } no es una imagen que este navegador pueda mostrar

edit-not-pasted = Eso no se puede pegar
edit-not-copied = Eso no se puede copiar
edit-sags = ¿El cuerpo se hunde?
    .text = Reinícialo y pulsa «Conservar esta forma», junto a las herramientas: el cuerpo quedará como lo dibujaste.

number-mixed = valores distintos
number-middle = centro
number-note = { $number } ({ $note })
number-proportions = Mantener proporciones
    .hint = un número fija entonces el valor mayor, y los demás cambian en proporción
number-holding = Masas
    .pin = Fijar
    .release = Soltar
number-rest = Reposo tal como está
    .hint = las longitudes y los ángulos naturales pasan a ser los actuales
number-delete = Eliminar
number-position-x = Inicio x
number-position-y = Inicio y
number-mass = Masa
number-radius = Radio
number-force-x = Fuerza x
number-force-y = Fuerza y
number-spring-stiffness = Rigidez
number-spring-damping = Amortiguamiento
number-spring-rest-length = Longitud natural
number-spring-strength = Resistencia a la rotura
number-spring-yield-force = Fuerza de fluencia
number-spring-hardening = Endurecimiento
number-joint-stiffness = Rigidez de la articulación
number-joint-damping = Amortiguamiento de la articulación
number-joint-rest-angle = Ángulo natural
number-joint-yield-torque = Momento de fluencia
number-spring-muscle-amplitude = Amplitud del músculo
number-spring-muscle-phase = Fase del músculo
number-spring-muscle-per-beat = Ondas del músculo por compás
number-joint-muscle-amplitude = Amplitud del músculo de la articulación
number-joint-muscle-phase = Fase del músculo de la articulación
number-joint-muscle-per-beat = Ondas del músculo de la articulación por compás
number-joint-motor-speed = Velocidad del motor
number-joint-motor-torque = Momento de fuerza del motor

way-touch = Las masas tocan
    .hint = las bolas chocan: rebotan unas en otras y, donde hay contacto, también en los resortes
    .usual = ninguna otra masa
    .solid = otras bolas
way-move = Las masas se mueven
    .hint = una masa sobre un carril se mueve solo a lo largo de él, como un carrito
    .usual = libremente
    .level = de un lado a otro, sobre un carril
    .upright = arriba y abajo, sobre un carril
way-springs = Los resortes actúan
    .hint = una cuerda solo tira, y un tope actúa en un solo lado de su ángulo natural
    .usual = en ambos sentidos
    .pull = solo tirando
    .push = solo empujando
way-joints = Las articulaciones actúan
    .hint = { way-springs.hint }
    .usual = en ambos lados
    .above = solo por encima de su ángulo
    .below = solo por debajo de su ángulo
way-turn = Las articulaciones giran
    .hint = un motor gira el segundo resorte de una articulación respecto al primero
    .usual = libremente
    .motor = con un motor
    .left-right = con un motor, con las teclas Izquierda y Derecha
    .up-down = con un motor, con las teclas Arriba y Abajo
way-forces = Las fuerzas actúan
    .hint = una fuerza sobre una masa actúa siempre, o mientras se mantiene pulsada una tecla de flecha
    .usual = siempre
    .left-right = con las teclas Izquierda y Derecha
    .up-down = con las teclas Arriba y Abajo
way-muscles = Los músculos trabajan
    .hint = un músculo trabaja siempre, o mientras se mantiene pulsada una tecla de flecha; uno constante se queda entonces como está
    .usual = al compás
    .left-right = al compás, con las teclas Izquierda y Derecha
    .up-down = al compás, con las teclas Arriba y Abajo
    .steady-left-right = de forma constante, con las teclas Izquierda y Derecha
    .steady-up-down = de forma constante, con las teclas Arriba y Abajo
way-joint-muscles = Los músculos de las articulaciones trabajan
    .hint = { way-muscles.hint }
    .usual = { way-muscles.usual }
    .left-right = { way-muscles.left-right }
    .up-down = { way-muscles.up-down }
    .steady-left-right = { way-muscles.steady-left-right }
    .steady-up-down = { way-muscles.steady-up-down }

done-masses-removed = { $count ->
    [one] { $count } masa eliminada
   *[other] { $count } masas eliminadas
}
done-springs-removed = { $count ->
    [one] { $count } resorte eliminado
   *[other] { $count } resortes eliminados
}
done-joints-removed = { $count ->
    [one] { $count } articulación eliminada
   *[other] { $count } articulaciones eliminadas
}
done-muscles-removed = { $count ->
    [one] { $count } músculo eliminado
   *[other] { $count } músculos eliminados
}
done-springs-cut = { $count ->
    [one] { $count } resorte cortado
   *[other] { $count } resortes cortados
}
done-springs-added = { $count ->
    [one] { $count } resorte añadido
   *[other] { $count } resortes añadidos
}
done-joints-added = { $count ->
    [one] { $count } articulación añadida
   *[other] { $count } articulaciones añadidas
}
done-muscles-added = { $count ->
    [one] { $count } músculo añadido
   *[other] { $count } músculos añadidos
}
done-masses-pinned = { $count ->
    [one] { $count } masa fijada
   *[other] { $count } masas fijadas
}
done-masses-let-go = { $count ->
    [one] { $count } masa soltada
   *[other] { $count } masas soltadas
}
done-masses-moved = { $count ->
    [one] { $count } masa movida
   *[other] { $count } masas movidas
}
done-masses-mirrored = { $count ->
    [one] { $count } masa reflejada
   *[other] { $count } masas reflejadas
}
done-masses-duplicated = { $count ->
    [one] { $count } masa duplicada
   *[other] { $count } masas duplicadas
}
done-masses-pasted = { $count ->
    [one] { $count } masa pegada
   *[other] { $count } masas pegadas
}
done-muscles-moved = { $count ->
    [one] { $count } músculo movido
   *[other] { $count } músculos movidos
}
done-muscles-changed = { $count ->
    [one] { $count } músculo cambiado
   *[other] { $count } músculos cambiados
}
done-muscles-spread = { $count ->
    [one] { $count } músculo repartido
   *[other] { $count } músculos repartidos
}
done-springs-critically-damped = { $count ->
    [one] { $count } resorte con amortiguamiento crítico
   *[other] { $count } resortes con amortiguamiento crítico
}
done-triangulated-springs-added = { $count ->
    [one] triangulado: { $count } resorte añadido
   *[other] triangulado: { $count } resortes añadidos
}
done-mass-added = masa añadida
done-mass-and-spring-added = masa y resorte añadidos
done-masses-and-a-spring-added = { $count } masas y un resorte añadidos
done-nothing-removed = nada eliminado
done-nothing-mirrored = nada reflejado
done-rest-as-it-is = reposo tal como está
done-keep-this-shape = conservar esta forma
done-fitted = ajuste a la tabla
done-scene-renamed = nombre de la escena cambiado
done-scene-described = escena descrita
done-mode = modo { $count }
done-own-values-of-the-body = valores originales del cuerpo
done-own-values-of-the-solver = valores originales del cálculo
done-number-set = { $number }, valor fijado: { $parts }
done-number-scaled = { $number }, en proporción: { $parts }
done-way = { $way }: { $choice }
done-lesson-deleted = lección eliminada
done-step-added = paso { $count } añadido
done-step-duplicated = paso { $count } duplicado
done-step-removed = paso { $count } eliminado
done-step-moved = «{ $title }» pasa a ser el paso { $count }
done-beginning-of-step = inicio del paso { $count }
done-title-of-step = título del paso { $count }
done-task-of-step = tarea del paso { $count }
done-what-to-watch-of-step = qué observar en el paso { $count }
done-question-of-step = pregunta del paso { $count }
done-prediction-of-step = predicción del paso { $count }
done-goal-of-step = objetivo del paso { $count }
done-what-is-handed-in-of-step = lo que se entrega en el paso { $count }
done-sliders-of-step = deslizadores del paso { $count }
done-plots-of-step = gráficas del paso { $count }
done-arrows-of-step = flechas del paso { $count }
done-second-body-of-step = segundo cuerpo del paso { $count }
done-run-of-step = simulación del paso { $count }

edit-no-corner = no hay ninguna esquina sin resorte angular
edit-no-brace = no queda nada que triangular
edit-no-selection = no hay nada seleccionado
edit-no-move = no hay nada seleccionado que se pueda mover
