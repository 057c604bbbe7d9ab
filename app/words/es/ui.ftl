ui-templates = Plantilla de ángulos
ui-mixed = { $setting } (valores distintos)
    .angles = el deslizador gira el primer ángulo, y los demás otro tanto
    .numbers = el deslizador fija el número mayor, y los demás mantienen su proporción con él
    .note = <b>valores distintos</b>: { $what }.
ui-range = de { $low } a { $high }

key-ctrl = Ctrl
key-shift = Mayús
key-space = Espacio
key-esc = Esc
key-delete = Supr
key-backspace = Retroceso
key-tab = Tab
key-or = { $one } o { $other }
key-too = { $text } ({ $key })
key-of = tecla { $keys }
    .held = tecla { $keys }, mantenida

ui-panel = Controles
    .hide = Ocultar el panel
    .show = Mostrar el panel
    .down = Ocultar los controles
    .up = Mostrar los controles
ui-scene = { $title }: elegir otra escena
ui-close = Cerrar
ui-progress = Progreso
ui-on = activado
    .off = desactivado
ui-plot-time = tiempo, s
ui-plot-said = { $label }: ahora { $now }; mínimo { $low } a los { $lowAt } s, máximo { $high } a los { $highAt } s.
ui-plot-over = { $label }: ahora { $now }; mínimo { $low } donde { $across } vale { $lowAt }, máximo { $high } donde vale { $highAt }.
ui-plot-level = { $label }: { $now } todo el tiempo.
ui-plot-none = { $label }: todavía no hay valores.
ui-plot-keys = Las flechas izquierda y derecha muestran otra parte del tiempo; arriba y abajo, una más corta o más larga; Inicio, todo
ui-plot-numbers = Números
    .caption = { $count } de los números a la vista, repartidos por igual; ciérralo y ábrelo para ver los más recientes

ui-found = Resultados
    .none = Nada se llama así. Lo que pertenece a una masa, un resorte o una articulación se encuentra cuando hay alguno seleccionado.

ui-number-unclear = { $written } podría ser { $one } o { $other }. Escribe uno de los dos.
ui-number-none = «{ $written }» no es un número. Escribe uno como 20000, 2e4 o 0,05.
ui-number-least = Como mínimo { $least }.
ui-number-most = Como máximo { $most }.
ui-number-sign = Cambiar el signo

ui-away = Sin conexión: tu cuerpo espera. Conectando de nuevo…
ui-blocked = La página se ha cargado, pero su conexión en directo falla: algo bloquea los WebSockets por el camino. Prueba con otra red, como la zona wifi del equipo en el que funciona softrod.
ui-loading = Cargando…
    .later = En una red lenta, la primera vez tarda hasta medio minuto.
ui-needs-javascript = softrod necesita JavaScript, que aquí está desactivado.
ui-needs-webgl = softrod dibuja con WebGL 2, que este navegador no tiene o tiene desactivado: permite la aceleración por hardware en sus ajustes o usa otro navegador.
ui-other-viser = Esta página no puede dibujar: su página de viser no es la versión compatible con softrod.
ui-not-loaded = La página no ha llegado entera:
ui-no-canvas = El navegador ya no dibuja esta página. Tu cuerpo está guardado:
    .reload = Volver a cargar

ui-pad = Teclas de flecha
    .up = Arriba
    .left = Izquierda
    .down = Abajo
    .right = Derecha

ui-body = { $count ->
    [one] Cuerpo de { $count } masa
   *[other] Cuerpo de { $count } masas
}
ui-mass = masa { $mass }, { $place }
    .first = masa { $mass }, { $place }. Las flechas eligen, Espacio agarra
    .tools = masa { $mass }, { $place }. Las flechas eligen, Intro hace lo que hace la herramienta, + añade una masa, X mueve una cruz
    .held = masa { $mass } en la mano. Las flechas la mueven
    .free = masa { $mass } suelta
    .none = ninguna masa
ui-place = x { $x }, y { $y } { $unit }
ui-opened = Se ha abierto: { $title }
ui-exploded = El cuerpo ha explotado y se ha detenido
ui-running = En marcha
    .paused = En pausa
ui-broken = { $count ->
    [0] Ningún resorte roto
    [one] { $count } resorte roto
   *[other] { $count } resortes rotos
}

ui-too-much = Demasiado a la vez
    .text = Las últimas peticiones no se han atendido. Inténtalo de nuevo dentro de un momento.
ui-stopped = Esta página se ha detenido
    .text = Se ha producido un error en el servidor. Vuelve a cargar la página para continuar.
ui-undo-afresh = Deshacer empieza de cero
    .text = Lo que se cambió antes de perder la conexión ya no se puede deshacer.
ui-commas = Coma decimal
    .hint = las tablas que se guardan llevan 0,5 en lugar de 0.5, y punto y coma entre las columnas

ui-no-preset = no hay ninguna escena predefinida llamada { $name }; elige una en la galería
ui-no-user = la página no ha identificado a su usuario; vuelve a cargarla e inténtalo de nuevo
ui-no-room = tienes aquí { $count } escenas, el máximo; elimina antes alguna
    .computer = en este equipo no caben más escenas de visitantes; descárgala en un archivo

ui-tab-play = Jugar
ui-tab-measure = Medir
ui-tab-solver = Cálculo
ui-tab-share = Compartir
ui-tab-lesson = Lección

ui-unsent = No se puede enviar
    .text = Es demasiado grande para que una página lo envíe: como máximo 4,7 MB, que son unas 11 000 masas.
ui-unsent-resume = No se puede reanudar
ui-unsent-link = No se puede abrir
ui-unsent-file = No se puede abrir
ui-unsent-paste = No se puede pegar
ui-unsent-rival = No se puede competir contra eso
ui-all-controls = Se muestran todos los controles
ui-no-scene = Esa dirección no tiene ninguna escena
