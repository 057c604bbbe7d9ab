fit-about = الجدول الذي يُفلَت على الصفحة يُرسم فوق الجسم، ويمكن ملاءمة المشهد معه. ولإنشاء جدول: { $link }.
    .link = القياس في مقطع فيديو
fit-table = { $count ->
    [zero] <b>{ $name }</b>: لا صفوف. أي كمية في كل عمود؟
    [one] <b>{ $name }</b>: صف واحد. أي كمية في كل عمود؟
    [two] <b>{ $name }</b>: صفان. أي كمية في كل عمود؟
    [few] <b>{ $name }</b>: { $count } صفوف. أي كمية في كل عمود؟
    [many] <b>{ $name }</b>: { $count } صفًا. أي كمية في كل عمود؟
   *[other] <b>{ $name }</b>: { $count } صف. أي كمية في كل عمود؟
}
fit-run = المحاولة
fit-column = مثل ⁦mass1.x⁩ أو ⁦-mass1.y⁩ أو ⁦90 - spring0.direction⁩ أو صيغة؛ واتركه فارغًا لإهماله
fit-scale = { $unit } لكل متر
    .hint = مقدار المتر الواحد من الجدول في المشهد
fit-sought = ما المطلوب إيجاده؟
fit-start = البداية (الأماكن والسرعات)
fit-origin = نقطة أصل الجدول
fit-length-scale = مقياس الطول
fit-fit = ملاءمة
fit-forget = ترك الجدول
fit-begins = تبدأ الملاءمة…
fit-goes-on = الملاءمة جارية: { $what }…
fit-cannot = <b>لا يمكن إجراء الملاءمة</b>: { $why }.
fit-error = حدث خطأ في الخادم.
fit-no-table = لا يوجد جدول
fit-many-masses = الحد الأقصى لعدد الكتل في ملاءمة على الصفحة { $count }؛ ويقبل الأمر ⁦softrod fit⁩ أكثر
fit-many-numbers = الحد الأقصى لعدد الأعداد في ملاءمة على الصفحة { $count }؛ ويقبل الأمر ⁦softrod fit⁩ أكثر
fit-no-scale = اكتب كم { $unit } من المشهد في المتر الواحد، ⁦0.000001..1e9⁩، أو اجعل مقياس الطول مطلوبًا
fit-choose = اختر من 1 إلى { $most } من الأعداد المطلوبة، لا { $count }
fit-compiling = ما زالت ترجمة البرنامج جارية؛ حاول مرة أخرى بعد لحظة
fit-changed = تغيّر المشهد في هذه الأثناء؛ أعد الملاءمة
fit-left = { $column }: الباقي { $noise }.
