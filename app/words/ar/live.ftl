live-picture = هذه صورة: لا تعمل النصوص البرمجية هنا. افتح الملف في متصفح ويب فيتحرك.
live-too-old = لا يستطيع هذا المتصفح عرض الملف؛ ويستطيع ذلك متصفح أحدث.
live-play = تشغيل
live-pause = إيقاف مؤقت
live-speed = السرعة

replay-again = تشغيل من جديد
replay-time = الزمن المعروض
replay-too-old = لا يستطيع هذا المتصفح تشغيل الملف؛ ويستطيع ذلك متصفح أحدث.

live-exploded = انفجر الجسم
live-back = العودة إلى ما قبل ذلك
live-side = عناصر التحكم والأعداد
live-lesson = الدرس
live-others = منزلقات أخرى
live-answers = سلّم إجاباتك
live-step = ⁦+1⁩ خطوة
live-time = الزمن
live-reset = إعادة الضبط
live-follow = اتباع
    .hint = اتباع المؤشر
live-view = العرض والمفاتيح

live-arrow-left = يسار: زوايا طبيعية أصغر
    .works = يسار: { $work }
live-arrow-up = أعلى: أطول
    .works = أعلى: { $work }
live-arrow-down = أسفل: أقصر
    .works = أسفل: { $work }
live-arrow-right = يمين: زوايا طبيعية أكبر
    .works = يمين: { $work }
live-work-motors = إدارة المحركات
live-work-muscles = تشغيل العضلات
live-work-forces = دفع الكتل

live-notes = في هذا الملف: { $notes }.
live-note-verlet = يتحرك الجسم بطريقة فيرليه بالسرعة من دون ضبط للخطأ
live-note-shape = شكل الجسم ثابت
live-note-sliders = لا يوجد منزلق لما يلي: { $settings }
live-note-controls = لا يوجد في الدرس عنصر تحكم لما يلي: { $settings }
live-note-plots = حُذفت الرسوم البيانية لما يلي: { $quantities }
live-note-ghost = لا يوجد جسم ثانٍ للمقارنة
live-note-arrows = لا توجد أسهم
live-note-goals = لا يُحكم على بعض الأهداف
live-note-runs = لا تُسلَّم أي محاولة

live-stopped = متوقف
live-paused = متوقف مؤقتًا
live-slowed = حركة مبطأة: { $rate } من السرعة الحقيقية
live-broken = { $count ->
    [zero] لا نوابض مقطوعة
    [one] نابض واحد مقطوع
    [two] نابضان مقطوعان
    [few] { $count } نوابض مقطوعة
    [many] { $count } نابضًا مقطوعًا
   *[other] { $count } نابض مقطوع
}
live-yielded = { $count ->
    [zero] لا نوابض مشوّهة تشوّهًا دائمًا
    [one] نابض واحد مشوّه تشوّهًا دائمًا
    [two] نابضان مشوّهان تشوّهًا دائمًا
    [few] { $count } نوابض مشوّهة تشوّهًا دائمًا
    [many] { $count } نابضًا مشوّهًا تشوّهًا دائمًا
   *[other] { $count } نابض مشوّه تشوّهًا دائمًا
}
live-limit = الخطوة الزمنية ⁦{ $step } ms⁩، ⁦{ $part } %⁩ من الحد
    .over = الخطوة الزمنية ⁦{ $step } ms⁩، ⁦{ $part } %⁩ من الحد: غير مستقر

live-joint = المفصل { $joint }
    .angle = الزاوية
    .rest = الزاوية الطبيعية
    .sine = الجيب
    .cosine = جيب التمام
live-energy = الطاقة، { $unit }
    .kinetic = الحركية
    .height = الارتفاع
    .linear = النوابض
    .angular = النوابض الزاوية

live-cause =
    .linear = الخطوة الزمنية ⁦{ $step } s⁩ أكبر من حد الاستقرار ⁦{ $limit } s⁩ الذي تحدده النوابض.
    .angular = الخطوة الزمنية ⁦{ $step } s⁩ أكبر من حد الاستقرار ⁦{ $limit } s⁩ الذي تحدده النوابض الزاوية.
    .small = الخطوة الزمنية أصغر من حد الاستقرار، لكن هذا الحد يصلح للحركات الصغيرة؛ وقد حُرّك الجسم أو أُعدّ بعنف شديد.
    .violent = حُرّك الجسم أو أُعدّ بعنف شديد.

live-downwards = { $quantity }، نحو الأسفل
live-over = بدلالة { $quantity }
live-swing = { $reading }، الزمن الدوري ⁦{ $period } s⁩، السعة { $amplitude }
live-swings = الأزمنة الدورية ⁦{ $periods } s⁩؛ السعات { $amplitudes }
live-at = عند ⁦{ $time } s⁩: { $readings }

live-own-words = بأسلوبك:
live-predict = انقل الكتل إلى حيث ستكون بعد ⁦{ $time } s⁩. ثم اضغط الزر.
    .done = سيكون هناك
    .seen = الخط الرفيع هو توقعك بعد ⁦{ $time } s⁩.
live-goal = الهدف: { $goal }.
    .now = الهدف: { $goal }. الآن: { $reading }.
    .reached = تحقق الهدف: { $goal }.

live-leaves = لا يغادر شيء هذا الملف من تلقاء نفسه. أعطِ معلمك الملف، أو أرِه رمز QR.
live-name = اسمك أو لقبك، إن أراد معلمك ذلك:
live-save = حفظ الإجابات في ملف
live-qr = رمز QR للإجابات
    .text = رمز QR هو النص الذي تحته، وعدد حروفه { $letters }.
    .left = رمز QR هو النص الذي تحته، وعدد حروفه { $letters }. وليس فيه متسع لما يلي: { $left }؛ أما الملف ففيه كل شيء.
live-left-prediction = توقع الخطوة { $step }
live-left-line = سطر الخطوة { $step }
    .end = نهاية سطر الخطوة { $step }

live-dark = داكن
live-larger = أكبر، لجهاز العرض
live-keys-drag = تُمسَك الكتلة ما دمت تسحبها؛ وعدة أصابع تسحب عدة كتل
    .keys = سحب
live-keys-play = تشغيل أو إيقاف مؤقت
    .keys = مسافة
live-keys-step = خطوة واحدة
live-keys-reset = إعادة الضبط: يبدأ الجسم من جديد والمنزلقات كما هي
live-keys-follow = الكتلة ذات الحلقة تتبع المؤشر أو تتوقف عن اتباعه
live-keys-longer = تصبح النوابض أطول أو أقصر
    .keys = ↑ ↓ ضغط مستمر
live-keys-bent = تكبر الزوايا الطبيعية أو تصغر
    .keys = → ← ضغط مستمر
live-keys-motors = تدور المحركات إلى الأمام وإلى الوراء
    .keys = الأسهم، ضغط مستمر
live-keys-dark = داكن أو أبيض؛ أكبر، لجهاز العرض
live-keys-body = إلى الجسم: وهناك تختار الأسهم كتلة، ويمسكها مفتاح المسافة، وتحركها الأسهم
    .keys = Tab
live-keys-help = هذه المساعدة

live-sheet-title = { $lesson }: للمعلم
live-sheet-needs = المدة بالدقائق نحو { $minutes }. تحتاج إلى حاسوب مع جهاز عرض، وإلى هاتف أو جهاز لوحي أو حاسوب لكل تلميذ أو تلميذين. ابدأ بالأمر { $command }؛ وينقلك { $next } من مرحلة إلى مرحلة.
live-sheet-next = التالي
live-sheet-how = اسأل: يجيب الجميع دون أن يرى أحد إجابة غيره. لا تقل ما الصحيح. إذا كانت نسبة الإجابات الصحيحة أقل من ⁦35 %⁩ فاشرح مرة أخرى؛ وإذا لم تتجاوز ⁦70 %⁩ فدعهم يتناقشون في أزواج ثم اسأل من جديد. شغّل التجربة، واكشف الإجابة، واطلب منهم كتابة سطر واحد عن السبب؛ ثم يجرّبون ويسلّمون.
live-sheet-ask = اسأل
live-sheet-predict = توقّع
    .text = يسحب كل تلميذ الجسم الباهت إلى حيث سيكون بعد ⁦{ $time } s⁩.
live-sheet-run = شغّل
live-sheet-reveal = اكشف
live-sheet-try = جرّب
live-sheet-watch = لاحظ
live-sheet-goal = الهدف
    .text = { $goal }.
live-sheet-collect = اجمع
    .text = المطلوب: { $reading }.
