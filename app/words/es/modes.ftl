modes-strip = Modos de vibración
modes-close = Cerrar los modos
    .hint = Cerrar
modes-how = Señala una barra, o ve a ella con Tab, para ver su forma. Súbela: el cuerpo oscila así. Mantenla pulsada, o mantén Espacio: se excita.
modes-looking = Se están buscando los modos.
modes-none = Sin modos: { $why }.
modes-still = no vibra alrededor de su postura de reposo
modes-shown = Los modos se muestran sobre la barra del tiempo
modes-reading = { $swings ->
    [no] Modo { $number }: { $frequency } Hz, { $amplitude }, no oscila, { $share } de la energía
   *[yes] Modo { $number }: { $frequency } Hz, { $amplitude }, amortiguamiento { $damping }, { $share } de la energía
}
modes-reading-driven = { $swings ->
    [no] Modo { $number }: { $frequency } Hz, { $amplitude }, no oscila, excitado
   *[yes] Modo { $number }: { $frequency } Hz, { $amplitude }, amortiguamiento { $damping }, excitado
}
modes-others = En ninguno de estos: modos más rápidos y lo que un movimiento grande tiene de más que los pequeños: { $share } de la energía
    .lacks = En ninguno de estos: modos más rápidos y lo que un movimiento grande tiene de más que los pequeños; los modos solos tendrían { $share } más
    .word = resto
modes-share = { $percent } %
    .least = menos del 0,1 %
modes-bar = Modo { $number }, { $frequency } hercios
    .others = En ningún modo
modes-value = { $amplitude }, { $share } de la energía
modes-driven = Se está excitando el modo { $number }
modes-level = Modo { $number }: { $percent } por ciento de una barra completa
modes-volume = Volumen
modes-sound = Sonido de los modos
    .on = Sonido: activado
    .off = Sonido: desactivado
