view-menu = Ver
    .hint = Ver: modo oscuro, proyector, ayuda y más
view-help = Cómo se usa softrod
view-help-drag = <b>Arrastra</b> cualquier masa. Las fijas se quedan donde las dejas, las libres caen. Arrastra el papel para moverlo; gira la rueda o pellizca para acercar o alejar.
view-help-change = <b>Cambia</b> la rigidez, el amortiguamiento, las longitudes y los ángulos en «Jugar», o dibuja tu propio cuerpo con «Editar».
view-help-measure = <b>Mide</b> con gráficas en las que se leen el periodo y el amortiguamiento, con flechas, una regla, un transportador y un cronómetro.
view-help-time = La barra de debajo del cuerpo vuelve a cualquier instante de la simulación. «Reproducir» continúa desde el instante que muestra; lo que ocurrió antes de retroceder queda como una línea fina. Haz clic en una masa o tócala para leer su articulación.
