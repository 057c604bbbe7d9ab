session-cannot = لا يمكن فعل هذا
session-busy = المشهد مشغول؛ حاول مرة أخرى
session-not-resumed = تعذّر الاستئناف: { $why }

session-exploded = انفجر الجسم
    .setting = الخطوة الزمنية ⁦{ $step } s⁩ أكبر من حد الاستقرار ⁦{ $limit } s⁩ عند القيمة { $value } لما يلي: { $setting }. المعروض هو آخر حالة سليمة. عد إلى ما قبل ذلك مباشرة، وخفّض أحدهما، وتابع؛ أو اضغط «إعادة الضبط».
    .part = الخطوة الزمنية ⁦{ $step } s⁩ أكبر من حد الاستقرار ⁦{ $limit } s⁩ الذي تحدده صلابة ما يلي: { $part }. المعروض هو آخر حالة سليمة. عد إلى ما قبل ذلك مباشرة، وخفّضها أو اختر طريقة التكامل «تلقائي»، وتابع؛ أو اضغط «إعادة الضبط».
    .otherwise = توقف قبل الخطوة { $step }: { $what }؛ { $why }. المعروض هو آخر حالة سليمة. عد إلى ما قبل ذلك مباشرة، و{ $remedy }، وتابع؛ أو اضغط «إعادة الضبط».
session-what-number = كان موضع الكتلة { $mass } أو سرعتها سيصبح عددًا غير منتهٍ
session-what-position = ابتعدت الكتلة { $mass } كثيرًا (أكثر من ⁦{ $limit } px⁩)
session-what-step = لا توجد خطوة من هنا قصيرة بما يكفي
session-what-speed = أصبحت الكتلة { $mass } سريعة جدًا (أكثر من ⁦{ $limit } px/s⁩)
session-why-law = قانون القوة في الدليل التعليمي ليست له طاقة، وقد يزيد سرعة الجسم بلا نهاية
session-why-violent = حُرّك الجسم أو أُعدّ بعنف شديد
session-why-violent-step = حُرّك الجسم أو أُعدّ بعنف شديد بالنسبة إلى هذه الخطوة الزمنية
session-why-small = الخطوة الزمنية أصغر من حد الاستقرار، لكن هذا الحد يصلح للحركات الصغيرة حول وضعية واحدة؛ وقد تتجاوزه الحركات الكبيرة أو السريعة
session-why-small-law = الخطوة الزمنية أصغر من حد الاستقرار، لكن هذا الحد يصلح للحركات الصغيرة حول وضعية واحدة؛ وقد تتجاوزه الحركات الكبيرة أو السريعة، وقانون القوة في الدليل التعليمي ليست له طاقة، وقد يزيد سرعة الجسم بلا نهاية
session-remedy-law = حرّكه برفق أكثر أو زد التخميد أو اختر قانون قوة آخر
session-remedy-gently = حرّكه برفق أكثر أو زد التخميد
session-remedy-step = خفّض الخطوة الزمنية أو اختر طريقة التكامل «تلقائي» أو زد التخميد أو حرّكه برفق أكثر
session-cause-linear-stiffness = صلابة الشد
session-cause-linear-damping = تخميد الشد
session-cause-angular-stiffness = صلابة الانحناء
session-cause-angular-damping = تخميد الانحناء
session-cause-air-friction = احتكاك الهواء
session-cause-one-sided = النوابض ذات الجانب الواحد
session-cause-resistance = المقاومة
session-cause-walls = الجدران
session-cause-fillings = الغازات والسوائل
session-cause-contact = التلامس
session-cause-motors = المحركات
session-cause-pushes = الدفعات
session-cause-rails = السكك

session-shape = لا يمكن الحفاظ على هذا الشكل
    .line = { $why } الخط يبيّن إلى أين يتحرك.
    .button = { $why } الزر «الحفاظ عليه بصلابة ⁦× { $times }⁩» يحقق ذلك.
    .both = { $why } الخط يبيّن إلى أين يتحرك. الزر «الحفاظ عليه بصلابة ⁦× { $times }⁩» يحقق ذلك.
    .text = { $why }

session-back-to = العودة إلى «{ $scene }»
    .undo = يعود بك «تراجع» إلى «{ $scene }».
    .redo = تعود بك «إعادة» إلى «{ $scene }».
session-opening = فتح { $scene }
session-own-body = القيم الأصلية للجسم
session-own-solver = القيم الأصلية للحساب

session-replay-ended = انتهت إعادة العرض
    .taken = توليت التحكم بدلًا من إعادة العرض.
    .stuck = لا يمكنها أن تستمر: { $why }.
    .agrees = إنها متفقة مع السجل: { $verdict }.
    .differs = إنها غير متفقة مع السجل: { $verdict }.
session-replayed = { $checks ->
    [zero] عدد الخطوات المعادة { $steps }؛ ولم يُجرَ أي فحص
    [one] عدد الخطوات المعادة { $steps }؛ والفحص متفق
    [two] عدد الخطوات المعادة { $steps }؛ والفحصان متفقان
    [few] عدد الخطوات المعادة { $steps }؛ والفحوص كلها متفقة، وعددها { $checks }
    [many] عدد الخطوات المعادة { $steps }؛ والفحوص كلها متفقة، وعددها { $checks }
   *[other] عدد الخطوات المعادة { $steps }؛ والفحوص كلها متفقة، وعددها { $checks }
}
    .digest = { $checks ->
    [zero] عدد الخطوات المعادة { $steps }؛ ولم يُجرَ أي فحص، البصمة { $digest }
    [one] عدد الخطوات المعادة { $steps }؛ والفحص متفق، البصمة { $digest }
    [two] عدد الخطوات المعادة { $steps }؛ والفحصان متفقان، البصمة { $digest }
    [few] عدد الخطوات المعادة { $steps }؛ والفحوص كلها متفقة، وعددها { $checks }، البصمة { $digest }
    [many] عدد الخطوات المعادة { $steps }؛ والفحوص كلها متفقة، وعددها { $checks }، البصمة { $digest }
   *[other] عدد الخطوات المعادة { $steps }؛ والفحوص كلها متفقة، وعددها { $checks }، البصمة { $digest }
}
session-differs = أول اختلاف عند الخطوة { $step }، ⁦t = { $time } s⁩ (الفحص { $check } من { $checks }؛ وهي متفقة عند الخطوة { $agreed })، { $how }
    .elsewhere = أول اختلاف عند الخطوة { $step }، ⁦t = { $time } s⁩ (الفحص { $check } من { $checks }؛ وهي متفقة عند الخطوة { $agreed })، { $how }؛ سُجّل على { $machine }، وهذا { $here }
session-differs-hidden = لا في المواضع والسرعات، بل فيما فعلته المفاتيح أو الأضرار أو الاحتكاك
session-differs-apart = أكبر مسافة سُجّلت لكتلة { $distance }
session-differs-unknown = أكبر مسافة غير معروفة
session-too-heavy = هذا الإطار أثقل من أن يُعرض في صفحة؛ ويستطيع ذلك الأمر ⁦`softrod run --inputs`⁩
session-log-plays = يُعرض سجل الآن؛ ولا شيء غيره للحفظ

session-awaited = يتحرك باستخدام NumPy حتى تنتهي ترجمة { $what }: عدد الأجزاء الجاهزة { $ready } من { $count }
session-preparing = جارٍ إعداد { $what }: عدد الأجزاء الجاهزة { $ready } من { $count }

session-errors-kept = الأخطاء لا تنمو: يُلتزم بالخطأ المسموح به { $tolerance }.
    .grow = تنمو الأخطاء ⁦× { $factor }⁩ في الثانية: يُلتزم بالخطأ المسموح به { $tolerance }.
session-errors-step = الأخطاء لا تنمو: خطوة زمنية أقصر تجعلها أصغر.
    .grow = تنمو الأخطاء ⁦× { $factor }⁩ في الثانية: خطوة زمنية أقصر تجعلها أصغر.
session-errors-lost = تنمو الأخطاء ⁦× { $factor }⁩ في الثانية: لا يضمن أي خطأ مسموح به مكان الجسم بعد ⁦{ $seconds } s⁩.
    .step = تنمو الأخطاء ⁦× { $factor }⁩ في الثانية: لا تضمن أي خطوة زمنية مكان الجسم بعد ⁦{ $seconds } s⁩.

session-plot-many = الحد الأقصى لعدد الكميات في الرسم البياني { $count }
session-plot-units = يتسع الرسم البياني لوحدتين، لا لما يلي: { $units }
session-mode-fast = الزمن الدوري للنمط { $mode } هو ⁦{ $period } s⁩، أي أقل من أربع خطوات زمنية
