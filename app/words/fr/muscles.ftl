muscles-strip = Muscles
muscles-how = Tire une marque de côté : quand il bouge. Vers le haut ou le bas : de combien.
muscles-kinds = Ce qui est déplacé
    .groups = { $count } groupes
    .muscles = { $count } muscles
muscles-selected = { $count ->
    [one] { $count } muscle sélectionné
   *[other] { $count } muscles sélectionnés
}
muscles-spring = ressort { $number }
muscles-joint = articulation { $number }
muscles-springs = groupe { $group }, ressorts { $from } à { $to }
muscles-joints = groupe { $group }, articulations { $from } à { $to }
muscles-moves = { $size } à { $crest } du battement
muscles-pointed = { $muscle } : { $moves }
muscles-mark = Muscle : { $muscle }
    .selected = Muscle : { $muscle }, sélectionné
muscles-tempo = Tempo
    .hertz = Tempo en Hz
muscles-wave = Onde des muscles sélectionnés
    .sine = Sinus
    .pulse = Impulsion
muscles-often = Ondes par battement des muscles sélectionnés
muscles-spread = Répartir
    .hint = Les muscles sélectionnés bougent l’un après l’autre, répartis également sur le battement
