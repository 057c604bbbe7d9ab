muscles-strip = العضلات
muscles-how = اسحب علامة إلى الجانب: متى تتحرك. إلى الأعلى أو الأسفل: بأي مقدار.
muscles-kinds = ما يُحرَّك
    .groups = المجموعات: { $count }
    .muscles = العضلات: { $count }
muscles-selected = { $count ->
    [zero] لا عضلات محددة
    [one] عضلة واحدة محددة
    [two] عضلتان محددتان
    [few] { $count } عضلات محددة
    [many] { $count } عضلة محددة
   *[other] { $count } عضلة محددة
}
muscles-spring = النابض { $number }
muscles-joint = المفصل { $number }
muscles-springs = المجموعة { $group }، النوابض من { $from } إلى { $to }
muscles-joints = المجموعة { $group }، المفاصل من { $from } إلى { $to }
muscles-moves = { $size } عند { $crest } من دورة الإيقاع
muscles-pointed = { $muscle }: { $moves }
muscles-mark = عضلة { $muscle }
    .selected = عضلة { $muscle }، محددة
muscles-tempo = سرعة الإيقاع
    .hertz = سرعة الإيقاع بوحدة Hz
muscles-wave = موجة العضلات المحددة
    .sine = جيبية
    .pulse = نبضة
muscles-often = عدد موجات العضلات المحددة في دورة الإيقاع
muscles-spread = توزيع
    .hint = تتحرك العضلات المحددة واحدة بعد الأخرى، بالتساوي على دورة الإيقاع
