hud-stopped = متوقف
hud-past = نظرة إلى الماضي
hud-paused = متوقف مؤقتًا
hud-rest = ساكن
hud-slow = حركة مبطأة: { $factor } من السرعة الحقيقية
hud-behind = لا يستطيع الجسم اللحاق بهذه السرعة: اليد متأخرة بمقدار { $distance }
hud-broken = { $count ->
    [zero] لا نوابض مقطوعة
    [one] نابض واحد مقطوع
    [two] نابضان مقطوعان
    [few] { $count } نوابض مقطوعة
    [many] { $count } نابضًا مقطوعًا
   *[other] { $count } نابض مقطوع
}
hud-yielded = { $count ->
    [zero] لا نوابض مشوّهة تشوّهًا دائمًا
    [one] نابض واحد مشوّه تشوّهًا دائمًا
    [two] نابضان مشوّهان تشوّهًا دائمًا
    [few] { $count } نوابض مشوّهة تشوّهًا دائمًا
    [many] { $count } نابضًا مشوّهًا تشوّهًا دائمًا
   *[other] { $count } نابض مشوّه تشوّهًا دائمًا
}
hud-squeezed = مضغوط
    .stretched = مشدود
hud-step = الخطوة الزمنية ⁦{ $step } ms⁩، ⁦{ $percent } %⁩ من الحد
    .unstable = الخطوة الزمنية ⁦{ $step } ms⁩، ⁦{ $percent } %⁩ من الحد: غير مستقر
    .explodes = الخطوة الزمنية ⁦{ $step } ms⁩، ⁦{ $percent } %⁩ من الحد: غير مستقر، وينفجر عند لمسه

card-sine = الجيب
card-cosine = جيب التمام
card-angle = الزاوية
card-rest-angle = الزاوية الطبيعية
card-of = من { $count }
card-mass = الكتلة { $mass }
card-joint = المفصل { $joint }
    .of = المفصل { $joint } (من { $count } هنا)
card-x = x
card-y = y
card-speed = السرعة
card-stiffness = الصلابة

rates-factor = معامل الزمن الحقيقي
rates-steps = عدد الخطوات في الثانية
rates-solver = زمن الحساب لكل إطار
rates-behind = تأخر الساعة
rates-rejected = المرفوض في الثانية
rates-fallbacks = الخطوات البديلة

errors-title = قابلية التنبؤ
    .compiled = تظهر بعد ترجمة البرنامج
    .held = لا توجد كتلة حرة
errors-grow = نمو الأخطاء
    .measured = جارٍ القياس لمدة ثانية
errors-factor = نمو الأخطاء في الثانية الأخيرة
errors-rate = المعدل
errors-time = زمن النمو إلى e أمثال
    .none = لا يوجد
errors-solver = زمن حسابها لكل إطار

tuning-slowest = أبطأ اهتزاز
tuning-elastic = أبطأ اهتزاز مرن
tuning-fastest = أسرع اهتزاز
tuning-calm = يهدأ بعد
    .after = { $time }، إلى العُشر
    .never = لا يهدأ: بلا تخميد
tuning-sag = التدلّي بفعل الجاذبية
    .loads = التدلّي بفعل الأحمال
    .value = { $sag }، الكتلة { $mass }
tuning-stable = مستقر حتى ⁦{ $step } ms⁩
    .always = مستقر عند أي خطوة
tuning-spring = النابض { $spring } وحده
tuning-spring-fastest = أسرع نابض وحده
tuning-rate = ⁦{ $frequency } Hz⁩، { $period }، نسبة التخميد { $ratio }
    .undamped = ⁦{ $frequency } Hz⁩، { $period }، بلا تخميد
    .none = لا يوجد
tuning-one-linear-stiffness = زيادة صلابة النوابض بنسبة ⁦1 %⁩
tuning-one-angular-stiffness = زيادة صلابة المفاصل بنسبة ⁦1 %⁩
tuning-one-gravity = زيادة الجاذبية بنسبة ⁦1 %⁩
tuning-more-sag = زيادة التدلّي بمقدار { $sag }
tuning-less-sag = نقصان التدلّي بمقدار { $sag }
tuning-faster = أسرع بنسبة ⁦{ $percent } %⁩
tuning-slower = أبطأ بنسبة ⁦{ $percent } %⁩

ghost-title = الشبح
    .compiled = { $ghost }: يظهر بعد ترجمة البرنامج
    .tolerance = الخطأ المسموح به / { $finer }
    .step = الخطوة / { $finer }
ghost-distance = المسافة الآن
ghost-worst = أكبر مسافة
ghost-solver = زمن حساب الشبح لكل إطار
ghost-error = نمو أي خطأ
    .factor = ⁦× { $factor }⁩ في الثانية
ghost-stopped = توقف الشبح
    .why = لقد انفجر

energy-title = الطاقة
    .compiled = يبدأ تتبُّعها بعد ترجمة البرنامج
energy-unit = الوحدة
energy-kinetic = الطاقة الحركية
energy-gravity = طاقة الارتفاع
    .loads = طاقة الارتفاع والأحمال
energy-linear = النوابض
energy-angular = النوابض الزاوية
energy-walls = العمق في الجدران
energy-fillings = الغازات والسوائل
energy-contact = التلامس
energy-anchors = شغل يدك
energy-damping = المفقود بالتخميد
energy-air = المفقود إلى الهواء والوسط
energy-friction = المفقود إلى الجدران والأرض والتلامس
energy-plastic = المفقود بالتشوّه الدائم
energy-broken = المفقود بالانقطاع
energy-law = الناتج عن قانون الدليل التعليمي
energy-keys = شغل المفاتيح
energy-muscles = شغل العضلات
energy-motors = شغل المحركات
energy-changes = تغييرات الإعدادات
energy-fallbacks = المفقود في الخطوات البديلة
energy-residual = الباقي: خطأ الطريقة

about-edit = تعديل الاسم والنص
    .new = تسمية هذا المشهد وذكر ما يعرضه
