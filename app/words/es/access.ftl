access-title = Acceso e idioma
access-language = Idioma
    .hint = El de la página; tus propias escenas se quedan en el suyo. Se conserva el cuerpo y lo que se puede deshacer.
access-letters = Letras como teclas
    .hint = Para quienes dictan sus textos o pulsan teclas sin querer. Las teclas con Ctrl, las flechas y Esc funcionan siempre.
    .always = siempre
    .body = mientras el cuerpo tiene el foco
    .never = nunca
access-taps = Tocar en vez de arrastrar
    .hint = Toca una cosa y después el lugar adonde va. Esc, u otro toque en la cosa, la devuelve a su sitio. Arrastrar también funciona.
access-larger = Más grande
    .hint = Todo más grande y más marcado.
access-contrast = Más contraste
    .hint = Las letras y los bordes destacan más.
access-still = Menos movimiento
    .hint = El viento, las vistas y las marcas no se mueven solos. El cuerpo se mueve cuando se reproduce.
access-sound = Sonido
    .hint = De las gráficas, de los modos y de lo que toca y se rompe.
access-events = Anunciar lo que ocurre
    .hint = Un lector de pantalla dice en pocas palabras lo que ocurre: lo que se rompe, toca, queda en reposo, se agarra o se suelta. Como mucho una frase cada dos segundos.
access-kept = Este dispositivo conserva estos ajustes.

# While something is picked up by a tap, and after that; $thing is one of the names below, or that of an instrument, a
# bar or a mark.
taps-held = Tomado: { $thing }. Toca el lugar adonde va. Esc, o un toque encima, lo devuelve a su sitio.
taps-put = Colocado: { $thing }
taps-back = Devuelto a su sitio: { $thing }
taps-nothing = Aquí no hay nada que tomar; un cuerpo en pausa es más fácil de tocar.
taps-button = Devolver
taps-selection = selección
taps-frame = esquina de un marco
taps-cut = final de un corte
taps-turn = ángulo natural de una articulación
taps-picture = imagen
# Of a plot: the end of the part of the time that is to be shown larger.
taps-part = final de la parte que se amplía
