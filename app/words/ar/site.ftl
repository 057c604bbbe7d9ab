site-title = حبال وأجسام لينة
site-about = كل صورة تفتح جسمًا متحركًا: اسحبه واثنِه وغيّر أعداده. يعمل ذلك في المتصفح، ولا يُرسَل شيء إلى أي مكان.
site-own = مشاهد خاصة
site-find = البحث عن مشهد
site-count = { $count ->
    [zero] لا مشاهد
    [one] مشهد واحد
    [two] مشهدان
    [few] { $count } مشاهد
    [many] { $count } مشهدًا
   *[other] { $count } مشهد
}
site-found = { $count ->
    [zero] { $found } من { $count } مشاهد
    [one] { $found } من مشهد واحد
    [two] { $found } من مشهدين
    [few] { $found } من { $count } مشاهد
    [many] { $found } من { $count } مشهدًا
   *[other] { $found } من { $count } مشهد
}
site-none = لا مشهد فيه كل هذه الكلمات.
site-unknown = لا يوجد هنا مشهد اسمه { $name }.
site-groups = المجموعات
site-dark = صفحة داكنة
site-made = صُنعت ببرنامج softrod. لا تحتاج هذه الصفحات إلى خادم ولا إلى شبكة.
site-kept = كل شيء موجود الآن على هذا الجهاز، ويُفتح هنا دون شبكة.

site-bar = المعرض
site-all = كل المشاهد
    .hint = كل المشاهد (O)
site-before = السابق: { $scene }
site-after = التالي: { $scene }
site-save = حفظ هذه الصفحة في ملف واحد
