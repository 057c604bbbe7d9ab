fit-about = Una tabla que se suelta sobre la página se dibuja encima del cuerpo, y la escena se puede ajustar a ella. { $link } crea una.
    .link = Medir en un video
fit-table = { $count ->
    [one] <b>{ $name }</b>: { $count } fila. ¿Qué magnitud es cada columna?
   *[other] <b>{ $name }</b>: { $count } filas. ¿Qué magnitud es cada columna?
}
fit-run = Ensayo
fit-column = como mass1.x, -mass1.y, 90 - spring0.direction o una fórmula; vacío para omitirla
fit-scale = { $unit } por metro
    .hint = cuánto mide en la escena un metro de la tabla
fit-sought = ¿Qué se busca?
fit-start = Inicio (lugares, velocidades)
fit-origin = Origen de la tabla
fit-length-scale = Escala de longitudes
fit-fit = Ajustar
fit-forget = Olvidar la tabla
fit-begins = Empieza el ajuste…
fit-goes-on = Ajuste en curso: { $what }…
fit-cannot = <b>No se puede ajustar</b>: { $why }.
fit-error = Se ha producido un error en el servidor.
fit-no-table = no hay ninguna tabla
fit-many-masses = una página ajusta como máximo { $count } masas; softrod fit admite más
fit-many-numbers = una página ajusta como máximo { $count } números; softrod fit admite más
fit-no-scale = escribe cuántos { $unit } de la escena son un metro, 0.000001..1e9, o busca la escala de longitudes
fit-choose = elige de 1 a { $most } números que se buscan, no { $count }
fit-compiling = el cálculo todavía se está compilando; inténtalo de nuevo dentro de un momento
fit-changed = la escena se ha cambiado entretanto; ajústala de nuevo
fit-left = { $column }: queda { $noise }.
