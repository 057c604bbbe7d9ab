muscles-strip = Muskeln
muscles-how = Ziehe eine Marke seitwärts: wann sie sich bewegt. Nach oben oder unten: wie weit.
muscles-kinds = Was bewegt wird
    .groups = { $count } Gruppen
    .muscles = { $count } Muskeln
muscles-selected = { $count ->
    [one] { $count } Muskel ausgewählt
   *[other] { $count } Muskeln ausgewählt
}
muscles-spring = Feder { $number }
muscles-joint = Gelenk { $number }
muscles-springs = Gruppe { $group }, Federn { $from } bis { $to }
muscles-joints = Gruppe { $group }, Gelenke { $from } bis { $to }
muscles-moves = { $size } bei { $crest } des Takts
muscles-pointed = { $muscle }: { $moves }
muscles-mark = Muskel: { $muscle }
    .selected = Muskel: { $muscle }, ausgewählt
muscles-tempo = Tempo
    .hertz = Tempo in Hz
muscles-wave = Welle der ausgewählten Muskeln
    .sine = Sinus
    .pulse = Puls
muscles-often = Wellen je Takt der ausgewählten Muskeln
muscles-spread = Verteilen
    .hint = Die ausgewählten Muskeln bewegen sich nacheinander, gleichmäßig über den Takt verteilt
