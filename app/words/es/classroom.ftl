class-title = softrod: una clase
class-needs-javascript = Una clase necesita JavaScript, que aquí está desactivado.
class-blocked = La página se ha cargado, pero su conexión en directo falla: algo bloquea los WebSockets por el camino. Prueba con otra red, como la zona wifi del equipo de tu docente.
class-over = La clase ha terminado.
class-why = ¿Por qué? Responde en una frase.
class-hand-in = Entrega lo que has encontrado.
class-goal = Objetivo: { $goal }
class-goal-met = Alcanzado: { $goal }
class-found = Lo que ha encontrado la clase
class-qr-code = Código QR de { $address }
class-plot = { $what } en función de { $over }: { $count ->
    [one] 1 punto
   *[other] { $count } puntos
  }
  .law = { $what } en función de { $over }: { $count ->
    [one] 1 punto
   *[other] { $count } puntos
  }; { $law }
class-plot-you = tú: { $value }
class-grip = Masa { $mass } de tu predicción: muévela con las teclas de flecha
class-grips = Tu predicción
class-moved-mass = Masa { $mass }: { $moved }
class-moved =
  .lower = { $length } más abajo
  .higher = { $length } más arriba
  .left = { $length } a la izquierda
  .right = { $length } a la derecha
class-where-put = vuestras predicciones

## La página del alumnado.

seat-region = Clase
seat-nothing-kept = Aquí no se guarda nada de lo que entregaste.
seat-away-alone = Sin conexión: tu cuerpo sigue moviéndose aquí, pero eso no cuenta. Conectando de nuevo…
seat-hand-up = Levantar la mano
seat-hand-is-up = Mano levantada
seat-on-page = Otra página de este navegador tiene ahora tu puesto.
seat-on-device = Otro dispositivo tiene ahora tu puesto.
seat-come-back = Volver aquí
seat-who = ¿Quién eres? Escribe tu nombre para que tu docente sepa de quién son estas respuestas.
seat-your-name = Tu nombre
seat-name-me = Ese es mi nombre
seat-on-wall = El tuyo está ahora en la pantalla común.
seat-follow = Ver el de mi docente
seat-own-body = Volver a mi cuerpo
seat-about = Este puesto
seat-why = La pregunta y el porqué
seat-waiting = Aún no le ha llegado a tu docente: se guarda aquí y se enviará en cuanto sea posible.
seat-letters = Las cuatro letras de la pantalla común
seat-come-in = Entrar

seat-is-in = Ya estás en la clase. Pronto empieza.
seat-look = Mira al frente.
seat-teacher-away = La página de tu docente no está disponible por un momento: espera.
seat-gathered = Mira al frente: este es el cuerpo de tu docente. El tuyo espera.
seat-follows = Este es el cuerpo de tu docente. El tuyo espera.
seat-paused = En pausa: mira al frente.
seat-can-change = Todavía puedes cambiarlo. Nadie más puede verlo aún.
seat-ask-drag = Mueve el cuerpo pálido hasta donde estará { $seconds } s después de empezar. Nadie más puede verlo aún.
seat-ask-both = Mueve el cuerpo pálido hasta donde estará { $seconds } s después de empezar y elige una respuesta. Nadie más puede verlo aún.
seat-ask-choose = Elige una respuesta. Nadie más puede verla aún.
seat-ask-again = Elige otra vez. Nadie más puede verlo aún.
seat-try = Experimenta: este cuerpo es tuyo.

seat-home-drag = Mueve el cuerpo pálido hasta donde estará { $seconds } s después de empezar. Luego se pone en marcha.
seat-home-both = Mueve el cuerpo pálido hasta donde estará { $seconds } s después de empezar y elige una respuesta. Luego se pone en marcha.
seat-home-choose = Elige una respuesta. Luego se pone en marcha.
seat-late-now = Lo que entregues ahora cuenta como tardío.
seat-home-own = Ahora te toca a ti: este cuerpo es tuyo.
seat-step = Paso { $number }
seat-step-done = Paso { $number }, hecho
seat-next-step = Siguiente: paso { $number } de { $steps }
seat-to-do = { $count ->
    [one] Queda por hacer: paso { $steps }.
   *[other] Quedan por hacer: pasos { $steps }.
  }
seat-all-done = Todos los pasos están hechos. Puedes cerrar esta página.
seat-told-on = Verás la respuesta correcta el { $date }.

seat-watch = Observa:
seat-chose-before = Antes elegiste: { $choice }
seat-chose = { $late ->
    [yes] Elegiste: { $choice } (tarde: después de mostrarse las respuestas).
   *[no] Elegiste: { $choice }.
  }
seat-right = La respuesta correcta: { $choice }.

seat-predict = Estará ahí
  .place = Entregar: { $place }
seat-predicted = Tu predicción está entregada
  .place = Tu predicción está entregada: { $place }
seat-handed-moved = Se muestran las respuestas: tu predicción se ha entregado tal como la habías movido.
seat-step-left = Un poco a la izquierda
seat-step-right = Un poco a la derecha
seat-step-up = Un poco hacia arriba
seat-step-down = Un poco hacia abajo

seat-because = Porque
seat-send = Enviar
seat-change = Cambiarlo
seat-sent = Enviado ✓
seat-pause = Pausar
seat-play = Reproducir
seat-reset = Reiniciar
seat-slow = A un cuarto de la velocidad
seat-reading = { $what }: { $reading }
seat-no-reading = Todavía no hay nada que leer: deja que se mueva un rato.
seat-hand-in = Entregar { $reading }
  .instead = Entregar { $reading } en su lugar
seat-hand-in-it = Entregarlo
  .instead = Entregar esto en su lugar
seat-hand-in-run = Entregar esta simulación
  .instead = Entregar esta simulación en su lugar
seat-handed = { $late ->
    [yes] Entregado (tarde: después de mostrarse las respuestas).
   *[no] Entregado.
  }
  .text = { $late ->
    [yes] Entregado: { $text } (tarde: después de mostrarse las respuestas).
   *[no] Entregado: { $text }.
  }

seat-first = Persona 1
seat-second = Persona 2
seat-another-name = Otro nombre
seat-two = Somos dos
seat-move = Seguir en otro dispositivo
seat-move-digits = En el otro dispositivo, escribe { $digits }
seat-had = Tenía un puesto en otro dispositivo: sus dos cifras
seat-take-over = Recuperarlo

## Lo que se dice a la clase en cada fase, y (.do) lo que se hace.

guide-lobby = Abrimos la dirección de la pantalla común y escribimos las cuatro letras.
  .do = Muestra la pantalla común con el proyector. Sigue cuando ya estén todos.
guide-show = Miramos el cuerpo: ¿qué lo sujeta y qué tira de él?
  .before = Señala las partes. No pulses todavía «Reproducir»: se pone en marcha después de la pregunta.
  .do = Señala las partes. Pulsa «Reproducir» para soltarlo: aquello por lo que se pregunta viene después.
guide-drag = Arrastramos el cuerpo pálido hasta donde estará { $seconds } s después de empezar.
guide-ask = Espera a que todos hayan respondido. No digas cuál es la correcta.
guide-again = Durante un minuto, cada cual intenta convencer a quien tiene al lado. Luego respondemos otra vez.
  .do = Escucha. No digas cuál es la correcta.
guide-results = ¿Quién quiere decir por qué eligió lo que eligió?
  .do = Escucha a dos personas que respondieron cosas distintas. No des todavía la respuesta correcta.
guide-changed = ¿Quién ha cambiado de opinión, y por qué?
  .do = No des todavía la respuesta correcta: la simulación la mostrará.
guide-run = Observamos qué hace.
  .do = Deja que siga en marcha hasta que todos hayan visto qué ocurre.
guide-run-new = Observamos qué hace. Esto es nuevo: { $runs }
guide-run-stops = Se detiene a los { $seconds } s. Compáralo con las predicciones.
guide-reveal = Esa es la respuesta. Cada cual explica por qué a quien tiene al lado.
  .predicted = La pantalla común muestra las predicciones junto al cuerpo y después la respuesta correcta. Deja pasar un momento antes de hablar.
  .do = La pantalla común muestra la respuesta correcta. Deja pasar un momento antes de hablar.
guide-explain = Marca dos respuestas con una estrella: salen en la pantalla común en la fase siguiente. Después explícalo con tus propias palabras: { $because }
guide-try = Recorre el aula. Las manos levantadas se ven a la derecha.
guide-collect = Entregamos: { $collects }.
guide-plot = Cuando la mayoría haya entregado, comenta con la clase su gráfica: ¿qué dice? Pulsa «Mostrar la ley», si aparece.
guide-collected = Cuando la mayoría haya entregado, pon una de las entregas en la pantalla común.

## Lo que el servidor dice a una página de una clase.

class-refuse-together = La clase avanza a la vez.
class-refuse-no-home-step = La tarea no tiene ese paso.
class-refuse-no-place = La clase no tiene ese punto.
class-refuse-sealed = Nadie ve las respuestas antes de que se muestren todas.
class-refuse-no-bodies = Ahora los puestos no tienen cuerpo propio.
class-refuse-gathered = Ahora todos miran el cuerpo de tu docente.
class-refuse-begun = La clase ha empezado: ya no se puede elegir su lección.
class-refuse-steps = Una clase tiene como máximo { $most } pasos; esta escena tiene { $steps }.
class-refuse-closed = La clase ha empezado; pide a tu docente que abra la puerta.
class-refuse-network = Tu red tiene { $seats } puestos, el máximo para una red; tu docente puede quitar algunos.
class-refuse-removed = Tu docente ha cerrado este puesto.
class-refuse-full = La clase está completa: tiene { $seats } puestos.
class-refuse-names = En esta clase los nombres se asignan.
class-refuse-no-name = Un nombre necesita al menos una letra.
class-refuse-same-name = Alguien ya tiene ese nombre.
class-refuse-digits = Ningún puesto tiene ahora ese número.
class-refuse-own-answers = Este dispositivo ya tiene un puesto con respuestas propias.
class-refuse-not-yours = Esa respuesta es de otra persona.
class-refuse-one = En este puesto hay una sola persona.
class-refuse-no-step = La clase no tiene ese paso.
class-refuse-not-asked = Eso no se le ha preguntado a la clase.
class-refuse-has-run = Ya lo has visto en marcha: cuenta tu primera respuesta.
class-refuse-shown = Las respuestas ya se han mostrado; la tuya queda como estaba.
class-refuse-answers = Un puesto puede dar { $most } respuestas.
class-refuse-no-seat = No existe ese puesto.
class-refuse-no-answer = No existe esa respuesta.
class-refuse-no-choice = La pregunta no tiene esa opción.
class-refuse-no-such-place = Este cuerpo no puede estar ahí.
class-refuse-no-letter = Una frase necesita al menos una letra.
class-at-goal = objetivo alcanzado
class-not-at-goal = objetivo no alcanzado
class-refuse-tries = Han sido demasiados intentos; vuelve a cargar la página para continuar.
class-refuse-begin = Este paso no puede empezar: { $reason }.
class-refuse-other-page = Otra página tiene ahora este puesto.
class-refuse-cannot-begin = Este paso no puede empezar.
class-refuse-no-run = Ahora no hay ninguna simulación que entregar.
class-refuse-replay = Se está reproduciendo un registro; no hay nada que entregar.
class-refuse-code = Ahora no hay aquí ninguna clase { $code }.
seat-try-again = Prueba otros valores y pulsa «Reiniciar».
class-told-at = { $day } de { $month ->
    [1] enero
    [2] febrero
    [3] marzo
    [4] abril
    [5] mayo
    [6] junio
    [7] julio
    [8] agosto
    [9] septiembre
    [10] octubre
    [11] noviembre
   *[12] diciembre
  } a las { $time }

## La pantalla común: lo que todos ven en el proyector.

class-answered = Han respondido: { $done } de { $all }
class-wrote = Han escrito una frase: { $done } de { $all }
class-handed-in = Han entregado: { $done } de { $all }
wall-nobody = ¿Nadie todavía? Puede que la red aísle los dispositivos: prueba con la zona wifi de este equipo.
wall-way-in = Abre { $address } y escribe { $code }
wall-scan = Escanea esto, o abre { $address } y escribe
wall-here = { $count ->
    [one] Hay { $count } persona aquí
   *[other] Hay { $count } personas aquí
  }
wall-step = Paso { $number } de { $steps }
wall-now = Ahora: { $runs }
wall-where = ¿Dónde estará { $seconds } s después de empezar?
wall-next = Ahora: explica por qué a quien tienes al lado.
wall-trying = { $count ->
   *[other] experimentando
  }
wall-exploded = { $count ->
    [one] explotado
   *[other] explotados
  }
wall-untouched = { $count ->
   *[other] sin tocar
  }
wall-at-goal = { $count ->
   *[other] en el objetivo
  }

## La página de quien da la clase.

desk-lead = Qué decir y qué hacer
desk-room = La clase
desk-over = La clase ha terminado
desk-nothing-kept = En este equipo no se guarda nada de lo que se entregó.

desk-here = { $count } aquí
desk-wall = Pantalla
desk-controls = Panel
  .label = Panel de controles de mi propio cuerpo
desk-not-kept = sin guardar
desk-saving = guardando…
desk-pupils-type = La clase escribe { $address } y { $code }.
desk-more = Más
desk-come-in = Cómo entra la clase

desk-lobby = Entrar
desk-show = Mirar el cuerpo
desk-ask = Preguntar
  .again = Preguntar otra vez
desk-results = Mostrar respuestas
  .again = Mostrar respuestas otra vez
desk-run = Poner en marcha
desk-reveal = Revelar la solución
desk-explain = Explicar en una frase
desk-try = Dejar experimentar
desk-collect = Recoger
desk-step = Paso { $number }
desk-steps = Paso
desk-phase = Fase { $number } de { $phases }
desk-minutes = { $minutes } min hasta ahora
desk-say = Decir
desk-do = Hacer
desk-next = Siguiente: { $place }
desk-last = Ese era el último paso.
desk-back = Atrás
  .label = Volver a: { $place }
desk-all-phases = Todas las fases

desk-teach = { $part } % de aciertos: explícalo otra vez.
  .some = { $part } % de aciertos (de momento han respondido { $votes }): explícalo otra vez.
desk-pairs = { $part } % de aciertos: deja que hablen en parejas y pregunta otra vez.
  .some = { $part } % de aciertos (de momento han respondido { $votes }): deja que hablen en parejas y pregunta otra vez.
desk-on = { $part } % de aciertos: sigue adelante.
  .some = { $part } % de aciertos (de momento han respondido { $votes }): sigue adelante.
desk-replay = Otra vez, despacio
  .now = Despacio, desde el principio…
desk-gather = Todos miran el mío
desk-pause = Pausar todos
desk-reset = Reiniciar todos
desk-give-mine = Dar el mío a todos
  .confirm = ¿Dar a todos tu cuerpo tal como está ahora? Lo que tienen se pierde.
desk-law = Mostrar la ley
desk-open = Abrir la puerta
desk-close = Cerrar la puerta
desk-own-names = Dejar que escriban sus nombres
desk-given-names = Asignar los nombres
desk-sheet = Guardar una hoja para imprimir
desk-zip = Guardar todo en un zip
desk-end = Terminar
  .confirm = ¿Terminar la clase? Se elimina todo lo que se entregó.

desk-home-until = Tarea para casa hasta el { $date }
  .about = Se puede entrar en cualquier momento, también sin ti. Las respuestas correctas se ven entonces, o en cuanto las muestres.
desk-home-told = Tarea para casa: respuestas mostradas
  .about = Todos ven las respuestas correctas. Lo que llegue ahora cuenta como tardío.
desk-tell = Mostrar ya las respuestas correctas
  .confirm = ¿Mostrar ya a todos las respuestas correctas? Lo que llegue después cuenta como tardío.
desk-home-step = { $number }. { $title }: respuestas { $answered }, entregas { $handed }

desk-lesson = Lección
desk-which-lesson = ¿Qué lección?
desk-lesson-steps = { $count ->
    [one] Tiene { $count } paso.
   *[other] Tiene { $count } pasos.
  }
desk-address = Dirección
desk-which-network = ¿En qué red está la clase?
desk-networks = Este equipo está en varias. Las direcciones de los dispositivos de la clase empiezan igual.
desk-lets-in = ¿La red los deja entrar?
desk-scan = Escanea esto con un teléfono que esté en la red de la clase, o abre { $address }
desk-finds-nothing = Si un teléfono no encuentra nada en esta dirección, la red aísla los dispositivos: usa la zona wifi de este equipo.

desk-tried-in-vain = Un dispositivo: no puede participar; en él se dice por qué.
desk-tried = Un dispositivo: todo bien, { $ms } ms, { $rate } imágenes por segundo
desk-tried-doubts = Un dispositivo: funciona, y en él se dice qué hay que tener en cuenta, { $ms } ms, { $rate } imágenes por segundo
desk-projector = Mostrar la pantalla común con el proyector
desk-open-wall = Abrir la pantalla común
desk-way-in = La pantalla común también lo muestra, en grande: así entra la clase.

desk-files = Respuestas en archivos
desk-from-files = De quienes tenían la lección en un archivo: cuentan como respuestas tardías, cada una una vez.
desk-lesson-file = Guardar para ellos la lección en un archivo
desk-their-files = Sus archivos
desk-codes = O el texto de sus códigos QR, escaneado o pegado
desk-take = Incorporar
desk-file-too-long = Ese archivo es demasiado largo para contener respuestas a una lección.
desk-brought = { $name }: { $count ->
    [one] 1 respuesta
   *[other] { $count } respuestas
  }.
desk-brought-known = { $name }: { $count ->
    [one] 1 respuesta
   *[other] { $count } respuestas
  }; ya se habían incorporado { $known }.
desk-brought-goals = { $count ->
    [one] Según su propio archivo, alcanzó el objetivo del paso { $steps }.
   *[other] Según su propio archivo, alcanzó el objetivo de los pasos { $steps }.
  }

desk-count-handed-in = { $count ->
    [one] ha entregado
   *[other] han entregado
  }
desk-count-trying = { $count ->
    [one] está experimentando
   *[other] están experimentando
  }
desk-count-exploded = { $count ->
    [one] ha explotado
   *[other] han explotado
  }
desk-count-idle = { $count ->
    [one] no ha cambiado nada
   *[other] no han cambiado nada
  }

desk-chose = Lo que eligieron
  .now = Lo que han elegido hasta ahora
desk-sealed = solo tú ves esto
desk-most = { $count ->
    [one] { $count } persona eligió «{ $choice }»: pregúntale por qué.
   *[other] { $count } personas eligieron «{ $choice }»: pregunta a una de ellas por qué.
  }
desk-predicted = Predicciones: { $count }.
  .some = Predicciones: { $count } de { $all }.
desk-found = Lo que han encontrado hasta ahora

desk-who = Quién está
desk-who-away = { $here }; ausentes: { $away }
desk-nobody = Nadie todavía.
desk-name-two = { $name } (dos)
desk-two = dos
desk-away = ausente
desk-follows = mira el tuyo
desk-done = { $done } de { $steps } pasos
desk-moving = en movimiento
desk-untouched = sin tocar
desk-at-rest = en reposo
desk-paused = en pausa
desk-exploded = ha explotado
desk-goal-reached = objetivo alcanzado
desk-on-wall = en la pantalla común
desk-has-predicted = ha predicho
desk-has-answered = ha respondido
desk-hand = mano levantada
desk-lower-hands = Bajar las manos
desk-to-wall = Poner en la pantalla común
desk-off-wall = Quitar de la pantalla común
desk-reset-one = Reiniciar este
desk-to-all = Volver a todos
desk-move = Pasar a otro dispositivo
desk-move-digits = En el otro dispositivo: { $digits }
desk-move-how = Allí hay que entrar, elegir «Este puesto» y escribir { $digits }.
desk-remove = Quitar
  .confirm = ¿Cerrar el puesto de { $name }? Lo que entregó también se elimina.

desk-work = Entregas: { $count }
desk-lines = Frases: { $count }
desk-predictions = Predicciones: { $count }
desk-gave = Ha dado: { $what }
desk-by = { $name }: { $what }
desk-a-prediction = una predicción
desk-a-run = una simulación
desk-late = { $what } (tarde)
desk-doubt = { $what }: { $doubt }
desk-star = Mostrar esta frase en la pantalla común, de { $name }
desk-show-body = Mostrar el cuerpo de { $name } en la pantalla común
desk-show-prediction = Mostrar solo la predicción de { $name } en la pantalla común

desk-not-possible = Eso no es posible
desk-cannot-begin = Este paso no puede empezar
desk-no-zip = No se ha podido crear el zip
desk-no-file = No se ha podido crear el archivo de la lección
desk-no-sheet = No se ha podido crear la hoja
desk-the-run = la simulación
desk-unkept-title = La clase no se está guardando
desk-unkept = { $reason }. Lo que se entregue ahora espera en las páginas de la clase, y se pierde si se cierran. Haz sitio en el disco del equipo en el que está la clase, o llévate el zip ahora.
desk-kept-title = La clase se guarda de nuevo
desk-kept = Todo lo que se entregó está en el disco.
desk-goes-on-title = La clase continúa
desk-goes-on = Su carpeta { $folder } no se puede eliminar: { $reason }.
class-refuse-no-body = Ese puesto no tiene ahora cuerpo propio.
class-refuse-no-replay = No hay ninguna simulación que ver otra vez.
class-refuse-replay-broken = La simulación no se puede ver otra vez: { $reason }.
class-refuse-classes = Un servidor admite como máximo { $most } clases.
class-refuse-scenes = Una clase tiene como máximo { $most } pasos; estas escenas tienen { $steps }.
class-refuse-no-code = Eso no es un código de respuestas: empieza por SR1 y tiene letras y cifras.
class-refuse-no-file = Ese archivo no contiene respuestas a una lección.
class-refuse-misread = El código se leyó con una letra equivocada: escanéalo otra vez.
class-refuse-other-steps = Estas respuestas son de una lección con otro número de pasos.
class-refuse-empty = Todavía no contiene ninguna respuesta.
class-refuse-other-lesson = Estas respuestas son de otra lección, no de la de esta clase.

class-doubt-begins = el registro empieza con { $what }.
class-doubt-goes-on = el registro continúa con { $what }.
class-doubt-begins-other = el registro empieza con una escena distinta de la del paso.
class-doubt-goes-on-other = el registro continúa con una escena distinta de la del paso.
class-doubt-sets = el registro ajusta { $what }, para lo que este paso no tiene deslizador.
class-doubt-never = el registro continúa desde donde el cuerpo nunca estuvo; empieza de nuevo y entrega esa simulación.
class-doubt-long = el registro tiene más de { $what }.

## El zip que se lleva quien da la clase.

zip-readme = 
    Lo que entregó una clase: { $steps ->
        [one] 1 paso
       *[other] { $steps } pasos
      }, { $seats ->
        [one] 1 puesto
       *[other] { $seats } puestos
      }.

    answers.csv      votos, frases y lo que se entregó, una fila cada uno
    found.csv        lo que se encontró y con qué valor se ajustó, una fila por simulación
    predictions.csv  dónde se predijo que estarían las masas, en las unidades de la escena, una fila por masa
    scenes/          lo que recorrió la clase; `softrod class scenes/*.json` lo recorre con otra clase
    logs/            las simulaciones entregadas; `softrod run --inputs ARCHIVO` repite una
    pictures/        cómo estaban los cuerpos cuando se entregaron

    Las tablas llevan coma decimal, y punto y coma entre las columnas.

    { $names } Cuando la clase se termina, nada de esto queda en el equipo en el que estaba.
zip-typed-names = Algunos puestos tienen nombres que escribió la clase.
zip-given-names = Los puestos tienen los nombres que se les asignaron.

zip-step = paso
zip-title = título
zip-asked = ronda
zip-seat = puesto
zip-name = nombre
zip-pupil = persona
zip-kind = tipo
zip-answer = respuesta
zip-right = correcta
zip-late = tarde
zip-starred = con estrella
zip-over = en función de
zip-over-unit = unidad de «en función de»
zip-setting = ajuste
zip-what = qué
zip-unit = unidad
zip-found = encontrado
zip-doubt = duda
zip-mass = masa
zip-x = x
zip-y = y

zip-vote = voto
zip-line = frase
zip-work = entrega
zip-yes = sí
zip-no = no
