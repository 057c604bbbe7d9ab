ui-templates = قالب الزوايا
ui-mixed = { $setting } (قيم مختلفة)
    .angles = المنزلق يدير الزاوية الأولى، ويدير الأخرى بالمقدار نفسه
    .numbers = المنزلق يحدد أكبر عدد، وتبقى نسبة الأعداد الأخرى إليه ثابتة
    .note = <b>قيم مختلفة</b>: { $what }.
ui-range = من { $low } إلى { $high }

key-ctrl = Ctrl
key-shift = Shift
key-space = مسافة
key-esc = Esc
key-delete = Delete
key-backspace = Backspace
key-tab = Tab
key-or = { $one } أو { $other }
key-too = { $text } ({ $key })
key-of = المفتاح { $keys }
    .held = المفتاح { $keys } مع الاستمرار في الضغط

ui-panel = عناصر التحكم
    .hide = إخفاء اللوحة
    .show = إظهار اللوحة
    .down = إخفاء عناصر التحكم
    .up = إظهار عناصر التحكم
ui-scene = { $title }: اختيار مشهد آخر
ui-close = إغلاق
ui-progress = التقدم
ui-on = مفعّل
    .off = معطّل
ui-plot-time = الزمن، s
ui-plot-said = { $label }: الآن { $now }؛ الأدنى { $low } عند { $lowAt } s، والأعلى { $high } عند { $highAt } s.
ui-plot-over = { $label }: الآن { $now }؛ الأدنى { $low } حيث { $across } يساوي { $lowAt }، والأعلى { $high } حيث يساوي { $highAt }.
ui-plot-level = { $label }: { $now } طوال الوقت.
ui-plot-none = { $label }: لا قيم بعد.
ui-plot-keys = سهما اليسار واليمين يعرضان جزءًا آخر من الزمن، وسهما الأعلى والأسفل جزءًا أقصر أو أطول، ومفتاح Home يعرض الكل
ui-plot-numbers = الأرقام
    .caption = { $count } من الأرقام الظاهرة موزعة بالتساوي؛ أغلقها وافتحها للأحدث

ui-found = نتائج البحث
    .none = لا شيء بهذا الاسم. وما يخص كتلة أو نابضًا أو مفصلًا يظهر بعد تحديد واحد منها.

ui-number-unclear = قد يعني { $written } العدد { $one } أو العدد { $other }. اكتب أحدهما.
ui-number-none = «{ $written }» ليس عددًا. اكتب عددًا مثل 20000 أو 2e4 أو 0.05.
ui-number-least = على الأقل { $least }.
ui-number-most = على الأكثر { $most }.
ui-number-sign = تغيير الإشارة

ui-away = لا يوجد اتصال: جسمك ينتظر. جارٍ إعادة الاتصال…
ui-blocked = حُمِّلت الصفحة، لكن اتصالها المباشر لا ينجح: شيء ما في الطريق يحجب WebSockets. جرّب شبكة أخرى، مثل نقطة اتصال الحاسوب الذي يعمل عليه softrod.
ui-loading = جارٍ التحميل…
    .later = على شبكة بطيئة قد تستغرق المرة الأولى نصف دقيقة.
ui-needs-javascript = يحتاج softrod إلى JavaScript، وهو معطّل هنا.
ui-needs-webgl = يرسم softrod باستخدام WebGL 2، وهو غير موجود في هذا المتصفح أو معطّل فيه: اسمح بتسريع العتاد في إعداداته، أو استخدم متصفحًا آخر.
ui-other-viser = لا تستطيع هذه الصفحة الرسم: صفحة viser فيها ليست بالإصدار الذي يدعمه softrod.
ui-not-loaded = لم تصل الصفحة كاملة:
ui-no-canvas = لم يعد المتصفح يرسم هذه الصفحة. جسمك محفوظ:
    .reload = إعادة التحميل

ui-pad = مفاتيح الأسهم
    .up = أعلى
    .left = يسار
    .down = أسفل
    .right = يمين

ui-body = { $count ->
    [zero] جسم بلا كتل
    [one] جسم من كتلة واحدة
    [two] جسم من كتلتين
    [few] جسم من { $count } كتل
    [many] جسم من { $count } كتلة
   *[other] جسم من { $count } كتلة
}
ui-mass = الكتلة { $mass }، { $place }
    .first = الكتلة { $mass }، { $place }. الأسهم تختار، ومفتاح المسافة يمسك
    .tools = الكتلة { $mass }، { $place }. الأسهم تختار، ومفتاح الإدخال يفعل ما تفعله الأداة، و+ يضيف كتلة، وX يحرك علامة التقاطع
    .held = الكتلة { $mass } في اليد. الأسهم تحركها
    .free = الكتلة { $mass } تُركت
    .none = لا كتلة
ui-place = x { $x }, y { $y } { $unit }
ui-opened = فُتح المشهد { $title }
ui-exploded = انفجر الجسم وتوقف
ui-running = يعمل
    .paused = متوقف مؤقتًا
ui-broken = { $count ->
    [zero] لا نوابض مقطوعة
    [one] نابض واحد مقطوع
    [two] نابضان مقطوعان
    [few] { $count } نوابض مقطوعة
    [many] { $count } نابضًا مقطوعًا
   *[other] { $count } نابض مقطوع
}

ui-too-much = طلبات كثيرة في وقت واحد
    .text = جرى تجاهل الطلبات الأخيرة. حاول مرة أخرى بعد لحظة.
ui-stopped = توقفت هذه الصفحة
    .text = حدث خطأ في الخادم. أعد تحميل الصفحة للمتابعة.
ui-undo-afresh = يبدأ التراجع من جديد
    .text = لم يعد ممكنًا التراجع عما تغيّر قبل انقطاع الاتصال.
ui-commas = فواصل عشرية
    .hint = في الجداول المحفوظة يُكتب ⁦0,5⁩ بدلًا من ⁦0.5⁩، وبين الأعمدة فواصل منقوطة

ui-no-preset = لا يوجد مشهد جاهز اسمه { $name }؛ اختر مشهدًا من المعرض
ui-no-user = لم تحدد الصفحة هوية مستخدمها؛ أعد تحميلها وحاول مرة أخرى
ui-no-room = بلغ عدد مشاهدك هنا الحد الأقصى، وهو { $count }؛ احذف بعضها أولًا
    .computer = لا يوجد على هذا الحاسوب متسع لمزيد من مشاهد الزوار؛ نزّل المشهد ملفًا

ui-tab-play = تجربة
ui-tab-measure = قياس
ui-tab-solver = حساب
ui-tab-share = مشاركة
ui-tab-lesson = درس

ui-unsent = لا يمكن إرسال هذا
    .text = حجمه أكبر مما ترسله صفحة: الحد الأقصى ⁦4.7 MB⁩، أي نحو 11000 كتلة.
ui-unsent-resume = لا يمكن استئناف هذا
ui-unsent-link = لا يمكن فتح هذا
ui-unsent-file = لا يمكن فتح هذا
ui-unsent-paste = لا يمكن لصق هذا
ui-unsent-rival = لا يمكن التسابق مع هذا
ui-all-controls = جميع عناصر التحكم ظاهرة
ui-no-scene = لا مشهد في هذا العنوان
