stage-away = El cuerpo está fuera de la vista. Mostrar toda la escena
stage-drag = arrástrame
stage-empty = Aquí todavía no hay nada construido.
    .draw = Dibujar un cuerpo
    .tap = Toca para poner una masa. Arrastra desde una masa para poner un resorte.
    .click = Haz clic para poner una masa. Arrastra desde una masa para poner un resorte.
    .taps = Toca para poner una masa. Toca una masa y luego otra para poner un resorte.
