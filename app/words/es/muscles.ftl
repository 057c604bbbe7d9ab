muscles-strip = Músculos
muscles-how = Arrastra una marca hacia los lados: cuándo se mueve. Hacia arriba o hacia abajo: cuánto.
muscles-kinds = Qué se mueve
    .groups = { $count } grupos
    .muscles = { $count } músculos
muscles-selected = { $count ->
    [one] { $count } músculo seleccionado
   *[other] { $count } músculos seleccionados
}
muscles-spring = resorte { $number }
muscles-joint = articulación { $number }
muscles-springs = grupo { $group }, resortes { $from } a { $to }
muscles-joints = grupo { $group }, articulaciones { $from } a { $to }
muscles-moves = { $size } en el punto { $crest } del compás
muscles-pointed = { $muscle }: { $moves }
muscles-mark = Músculo: { $muscle }
    .selected = Músculo: { $muscle }, seleccionado
muscles-tempo = Ritmo
    .hertz = Ritmo en Hz
muscles-wave = Onda de los músculos seleccionados
    .sine = Seno
    .pulse = Pulso
muscles-often = Ondas por compás de los músculos seleccionados
muscles-spread = Repartir
    .hint = Los músculos seleccionados se mueven uno tras otro, repartidos por igual en el compás
