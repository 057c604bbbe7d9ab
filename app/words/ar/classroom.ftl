class-title = softrod: حصة
class-needs-javascript = تحتاج الحصة إلى JavaScript، وهو معطّل هنا.
class-blocked = حُمِّلت الصفحة، لكن اتصالها المباشر لا ينجح: شيء ما في الطريق يحجب WebSockets. جرّب شبكة أخرى، مثل نقطة اتصال حاسوب المعلم.
class-over = انتهت الحصة.
class-why = لماذا؟ أجب بجملة واحدة.
class-hand-in = سلّم ما وجدته.
class-goal = الهدف: { $goal }
class-goal-met = تحقق الهدف: { $goal }
class-found = ما وجده الصف
class-qr-code = رمز QR للعنوان { $address }
class-plot = { $what } بدلالة { $over }: { $count ->
    [zero] لا نقاط
    [one] نقطة واحدة
    [two] نقطتان
    [few] { $count } نقاط
    [many] { $count } نقطة
   *[other] { $count } نقطة
  }
  .law = { $what } بدلالة { $over }: { $count ->
    [zero] لا نقاط
    [one] نقطة واحدة
    [two] نقطتان
    [few] { $count } نقاط
    [many] { $count } نقطة
   *[other] { $count } نقطة
  }؛ { $law }
class-plot-you = أنت: { $value }
class-grip = الكتلة { $mass } في توقعك: حرّكها بمفاتيح الأسهم
class-grips = توقعك
class-moved-mass = الكتلة { $mass }: { $moved }
class-moved =
  .lower = { $length } إلى الأسفل
  .higher = { $length } إلى الأعلى
  .left = { $length } إلى اليسار
  .right = { $length } إلى اليمين
class-where-put = توقعاتكم

seat-region = الحصة
seat-nothing-kept = لا يُحفظ هنا شيء مما قدّمته.
seat-away-alone = لا يوجد اتصال: يتابع جسمك حركته هنا، ولا يُحتسب ذلك. جارٍ إعادة الاتصال…
seat-hand-up = رفع اليد
seat-hand-is-up = اليد مرفوعة
seat-on-page = صفحة أخرى في هذا المتصفح لها مقعدك الآن.
seat-on-device = جهاز آخر له مقعدك الآن.
seat-come-back = العودة إلى هنا
seat-who = من أنت؟ اكتب اسمك ليعرف معلمك لمن هذه الإجابات.
seat-your-name = اسمك
seat-name-me = هذا أنا
seat-on-wall = ما قدّمته معروض على الشاشة الآن.
seat-follow = شاهد جسم المعلم
seat-own-body = العودة إلى جسمي
seat-about = هذا المقعد
seat-why = السؤال والسبب
seat-waiting = لم يصل إلى المعلم بعد: هو محفوظ هنا، ويُرسل حالما يصبح ذلك ممكنًا.
seat-letters = الحروف الأربعة على الشاشة
seat-come-in = دخول

seat-is-in = دخلت. ستبدأ الحصة قريبًا.
seat-look = انظر إلى الأمام.
seat-teacher-away = صفحة معلمك غير متصلة للحظة: انتظر.
seat-gathered = انظر إلى الأمام: هذا جسم معلمك. وجسمك ينتظر.
seat-follows = هذا جسم معلمك. وجسمك ينتظر.
seat-paused = إيقاف مؤقت: انظر إلى الأمام.
seat-can-change = ما زال بإمكانك تغييرها. لا يستطيع أحد غيرك رؤيتها بعد.
seat-ask-drag = انقل الجسم الباهت إلى حيث سيكون بعد ⁦{ $seconds } s⁩ من البداية. لا يستطيع أحد غيرك رؤية ذلك بعد.
seat-ask-both = انقل الجسم الباهت إلى حيث سيكون بعد ⁦{ $seconds } s⁩ من البداية، واختر إجابة. لا يستطيع أحد غيرك رؤية ذلك بعد.
seat-ask-choose = اختر إجابة. لا يستطيع أحد غيرك رؤيتها بعد.
seat-ask-again = اختر مرة أخرى. لا يستطيع أحد غيرك رؤية اختيارك بعد.
seat-try = جرّب: هذا الجسم لك.

seat-home-drag = انقل الجسم الباهت إلى حيث سيكون بعد ⁦{ $seconds } s⁩ من البداية. ثم يبدأ التشغيل.
seat-home-both = انقل الجسم الباهت إلى حيث سيكون بعد ⁦{ $seconds } s⁩ من البداية واختر إجابة. ثم يبدأ التشغيل.
seat-home-choose = اختر إجابة. ثم يبدأ التشغيل.
seat-late-now = ما تقدّمه الآن يُعدّ متأخرًا.
seat-home-own = جاء دورك الآن: هذا الجسم لك.
seat-step = الخطوة { $number }
seat-step-done = الخطوة { $number }، منجزة
seat-next-step = التالي: الخطوة { $number } من { $steps }
seat-to-do = { $count ->
    [one] بقيت الخطوة { $steps }.
    [two] بقيت الخطوتان { $steps }.
    [few] بقيت الخطوات { $steps }.
    [many] بقيت الخطوات { $steps }.
   *[other] بقيت الخطوات { $steps }.
  }
seat-all-done = أُنجزت كل الخطوات. يمكنك إغلاق هذه الصفحة.
seat-told-on = سترى الإجابة الصحيحة في { $date }.

seat-watch = لاحظ:
seat-chose-before = اخترت من قبل: { $choice }
seat-chose = { $late ->
    [yes] اخترت: { $choice } (متأخرًا: بعد كشف الإجابات).
   *[no] اخترت: { $choice }.
  }
seat-right = الإجابة الصحيحة: { $choice }.

seat-predict = سيكون هناك
  .place = تسليم { $place }
seat-predicted = سُلّم توقعك
  .place = سُلّم توقعك: { $place }
seat-handed-moved = عُرضت الإجابات: سُلِّم توقعك كما حرّكته.
seat-step-left = قليلًا إلى اليسار
seat-step-right = قليلًا إلى اليمين
seat-step-up = قليلًا إلى الأعلى
seat-step-down = قليلًا إلى الأسفل

seat-because = لأنّ
seat-send = إرسال
seat-change = تغيير
seat-sent = أُرسل ✓
seat-pause = إيقاف مؤقت
seat-play = تشغيل
seat-reset = إعادة الضبط
seat-slow = بربع السرعة
seat-reading = { $what }: { $reading }
seat-no-reading = لا شيء يُقرأ بعد: دعه يتحرك قليلًا.
seat-hand-in = تسليم { $reading }
  .instead = تسليم { $reading } بدلًا مما سبق
seat-hand-in-it = تسليم
  .instead = تسليمه بدلًا مما سبق
seat-hand-in-run = تسليم هذه المحاولة
  .instead = تسليم هذه المحاولة بدلًا مما سبق
seat-handed = { $late ->
    [yes] تم التسليم (متأخرًا: بعد كشف الإجابات).
   *[no] تم التسليم.
  }
  .text = { $late ->
    [yes] تم تسليم: { $text } (متأخرًا: بعد كشف الإجابات).
   *[no] تم تسليم: { $text }.
  }

seat-first = الأول منكما
seat-second = الثاني منكما
seat-another-name = اسم آخر
seat-two = نحن اثنان
seat-move = المتابعة على جهاز آخر
seat-move-digits = اكتب على الجهاز الآخر { $digits }
seat-had = كان لي مقعد على جهاز آخر: رقماه
seat-take-over = نقله إلى هنا

guide-lobby = افتحوا العنوان المعروض على الشاشة، واكتبوا الحروف الأربعة.
  .do = اعرض شاشة العرض بجهاز العرض. تابع عندما يحضر الجميع.
guide-show = انظروا إلى الجسم: ما الذي يثبّته، وما الذي يشدّه؟
  .before = أشر إلى الأجزاء. لا تضغط «تشغيل» بعد: يبدأ التشغيل بعد السؤال.
  .do = أشر إلى الأجزاء. اضغط «تشغيل» لتركه يتحرك: أما ما يُسأل عنه فيأتي لاحقًا.
guide-drag = اسحبوا الجسم الباهت إلى حيث سيكون بعد ⁦{ $seconds } s⁩ من البداية.
guide-ask = انتظر حتى يجيب الجميع. لا تقل أيّ الإجابات صحيح.
guide-again = ليحاول كل منكم إقناع زميله لمدة دقيقة. ثم أجيبوا مرة أخرى.
  .do = استمع. لا تقل أيّ الإجابات صحيح.
guide-results = من يريد أن يقول لماذا اختار ما اختاره؟
  .do = استمع إلى اثنين اختلفت إجابتاهما. لا تُعطِ الإجابة الصحيحة بعد.
guide-changed = من غيّر رأيه، ولماذا؟
  .do = لا تُعطِ الإجابة الصحيحة بعد: سيُظهرها التشغيل.
guide-run = لاحظوا ما يفعله.
  .do = دعه يعمل حتى يرى الجميع ما يحدث.
guide-run-new = لاحظوا ما يفعله. الجديد هو: { $runs }
guide-run-stops = يتوقف عند ⁦{ $seconds } s⁩. قارنه بالتوقعات.
guide-reveal = هذه هي الإجابة. ليشرح كل منكم السبب لزميله.
  .predicted = تعرض الشاشة التوقعات إلى جانب الجسم، ثم الإجابة الصحيحة. انتظر لحظة قبل أن تتكلم.
  .do = تعرض الشاشة الإجابة الصحيحة. انتظر لحظة قبل أن تتكلم.
guide-explain = ضع نجمة على إجابتين: تُعرضان على الشاشة في المرحلة التالية. ثم اشرح بأسلوبك: { $because }
guide-try = تجوّل بينهم. تظهر الأيدي المرفوعة في قسم «الحصة».
guide-collect = سلّموا ما يلي: { $collects }.
guide-plot = عندما يسلّم معظمهم، انظروا معًا إلى الرسم البياني للصف: ماذا يقول؟ اضغط «إظهار القانون» إن كان معروضًا.
guide-collected = عندما يسلّم معظمهم، اعرض واحدة مما سُلّم على الشاشة.

class-refuse-together = يسير الصف معًا.
class-refuse-no-home-step = لا توجد خطوة كهذه في الواجب المنزلي.
class-refuse-no-place = لا يوجد موضع كهذا في الحصة.
class-refuse-sealed = لا يرى أحد الإجابات قبل عرضها جميعًا.
class-refuse-no-bodies = ليس للمقاعد أجسام خاصة بها الآن.
class-refuse-gathered = الجميع يشاهدون جسم المعلم الآن.
class-refuse-begun = بدأت الحصة: لم يعد ممكنًا اختيار درسها.
class-refuse-steps = الحد الأقصى لعدد خطوات الحصة { $most }؛ وعددها في هذا المشهد { $steps }.
class-refuse-closed = بدأت الحصة؛ اطلب من معلمك فتح الباب.
class-refuse-network = عدد مقاعد شبكتك { $seats }، وهو الحد الأقصى لشبكة واحدة؛ ويستطيع معلمك إزالة بعضها.
class-refuse-removed = أغلق المعلم هذا المقعد.
class-refuse-full = الحصة ممتلئة: عدد مقاعدها { $seats }.
class-refuse-names = في هذه الحصة تُعطى الأسماء.
class-refuse-no-name = يجب أن يكون في الاسم حرف.
class-refuse-same-name = هذا الاسم لشخص آخر.
class-refuse-digits = لا مقعد بهذا الرقم الآن.
class-refuse-own-answers = لهذا الجهاز مقعد فيه إجابات خاصة به.
class-refuse-not-yours = هذه الإجابة لشخص آخر.
class-refuse-one = يجلس هنا شخص واحد فقط.
class-refuse-no-step = لا توجد خطوة كهذه في الحصة.
class-refuse-not-asked = لم يُطلب ذلك من الصف.
class-refuse-has-run = لقد رأيت التشغيل: تُحتسب إجابتك الأولى.
class-refuse-shown = عُرضت الإجابات؛ وبقيت إجابتك كما كانت.
class-refuse-answers = الحد الأقصى لعدد الإجابات من المقعد الواحد { $most }.
class-refuse-no-seat = لا يوجد مقعد كهذا.
class-refuse-no-answer = لا توجد إجابة كهذه.
class-refuse-no-choice = لا يوجد في السؤال اختيار كهذا.
class-refuse-no-such-place = هذا ليس موضعًا لهذا الجسم.
class-refuse-no-letter = يجب أن يكون في السطر حرف.
class-at-goal = تحقق الهدف
class-not-at-goal = لم يتحقق الهدف
class-refuse-tries = كانت المحاولات كثيرة جدًا؛ أعد تحميل الصفحة للمتابعة.
class-refuse-begin = لا يمكن أن تبدأ هذه الخطوة: { $reason }.
class-refuse-other-page = صفحة أخرى لها هذا المقعد الآن.
class-refuse-cannot-begin = لا يمكن أن تبدأ هذه الخطوة.
class-refuse-no-run = لا توجد محاولة لتسليمها الآن.
class-refuse-replay = يُعرض سجل الآن؛ لا يوجد ما يُسلَّم.
class-refuse-code = لا توجد هنا الآن حصة رمزها { $code }.
seat-try-again = جرّب قيمًا أخرى، واضغط «إعادة الضبط».
class-told-at = { $day } { $month ->
    [1] يناير
    [2] فبراير
    [3] مارس
    [4] أبريل
    [5] مايو
    [6] يونيو
    [7] يوليو
    [8] أغسطس
    [9] سبتمبر
    [10] أكتوبر
    [11] نوفمبر
   *[12] ديسمبر
  }، { $time }

class-answered = عدد من أجابوا: { $done } من { $all }
class-wrote = عدد من كتبوا سطرًا: { $done } من { $all }
class-handed-in = عدد من سلّموا: { $done } من { $all }
wall-nobody = لا أحد بعد؟ قد تعزل الشبكات الأجهزة بعضها عن بعض: جرّب نقطة اتصال هذا الحاسوب.
wall-way-in = افتح { $address } واكتب { $code }
wall-scan = امسح هذا الرمز، أو افتح { $address } واكتب
wall-here = { $count ->
    [zero] لا أحد هنا
    [one] شخص واحد هنا
    [two] شخصان هنا
    [few] { $count } أشخاص هنا
    [many] { $count } شخصًا هنا
   *[other] { $count } شخص هنا
  }
wall-step = الخطوة { $number } من { $steps }
wall-now = الآن: { $runs }
wall-where = أين سيكون بعد ⁦{ $seconds } s⁩ من البداية؟
wall-next = التالي: اشرح السبب لزميلك.
wall-trying = { $count ->
   *[other] قيد التجربة
  }
wall-exploded = { $count ->
   *[other] بعد انفجار
  }
wall-untouched = { $count ->
   *[other] دون لمس
  }
wall-at-goal = { $count ->
   *[other] عند الهدف
  }

desk-lead = ما يقال ويُفعل
desk-room = الحصة
desk-over = انتهت الحصة
desk-nothing-kept = لا يُحفظ على هذا الحاسوب شيء مما قُدّم.

desk-here = هنا: { $count }
desk-wall = الشاشة
desk-controls = التحكم
  .label = التحكم في جسمي
desk-not-kept = غير محفوظ
desk-saving = جارٍ الحفظ…
desk-pupils-type = يكتب التلاميذ { $address } و { $code }.
desk-more = المزيد
desk-come-in = كيف يدخل التلاميذ

desk-lobby = الدخول
desk-show = انظروا إليّ
desk-ask = طرح السؤال
  .again = طرح السؤال من جديد
desk-results = عرض الإجابات
  .again = عرض الإجابات من جديد
desk-run = التشغيل
desk-reveal = كشف الإجابة
desk-explain = الشرح في سطر
desk-try = دعهم يجرّبون
desk-collect = الجمع
desk-step = الخطوة { $number }
desk-steps = الخطوة
desk-phase = المرحلة { $number } من { $phases }
desk-minutes = ⁦{ $minutes } min⁩ حتى الآن
desk-say = قل
desk-do = افعل
desk-next = التالي: { $place }
desk-last = كانت تلك الخطوة الأخيرة.
desk-back = رجوع
  .label = رجوع إلى: { $place }
desk-all-phases = كل المراحل

desk-teach = ⁦{ $part } %⁩ صحيحة: اشرح مرة أخرى.
  .some = ⁦{ $part } %⁩ صحيحة من الإجابات، وعددها حتى الآن { $votes }: اشرح مرة أخرى.
desk-pairs = ⁦{ $part } %⁩ صحيحة: دعهم يتناقشون في أزواج، ثم اسأل من جديد.
  .some = ⁦{ $part } %⁩ صحيحة من الإجابات، وعددها حتى الآن { $votes }: دعهم يتناقشون في أزواج، ثم اسأل من جديد.
desk-on = ⁦{ $part } %⁩ صحيحة: تابع.
  .some = ⁦{ $part } %⁩ صحيحة من الإجابات، وعددها حتى الآن { $votes }: تابع.
desk-replay = من جديد، ببطء
  .now = ببطء، من البداية…
desk-gather = ليشاهد الجميع جسمي
desk-pause = إيقاف الجميع مؤقتًا
desk-reset = إعادة ضبط الجميع
desk-give-mine = إعطاء جسمي للجميع
  .confirm = هل تعطي كل واحد جسمك كما هو الآن؟ سيضيع ما لديهم.
desk-law = إظهار القانون
desk-open = فتح الباب
desk-close = إغلاق الباب
desk-own-names = دعهم يكتبون أسماءهم
desk-given-names = أسماء من البرنامج
desk-sheet = حفظ ورقة للطباعة
desk-zip = حفظ الكل في ملف zip
desk-end = إنهاء
  .confirm = هل تنهي الحصة؟ سيُحذف كل ما قُدّم.

desk-home-until = واجب منزلي حتى { $date }
  .about = يدخل التلاميذ في أي وقت من دونك. ويرون الإجابات الصحيحة في ذلك الموعد، أو حالما تكشفها.
desk-home-told = واجب منزلي: كُشفت الإجابات
  .about = يرى الجميع الإجابات الصحيحة. وما يصل الآن يُعدّ متأخرًا.
desk-tell = كشف الإجابات الصحيحة الآن
  .confirm = هل تكشف الإجابات الصحيحة للجميع الآن؟ ما يصل بعد ذلك يُعدّ متأخرًا.
desk-home-step = { $number }. { $title }: أجاب { $answered }، وسلّم { $handed }

desk-lesson = الدرس
desk-which-lesson = أي درس؟
desk-lesson-steps = { $count ->
    [zero] ليس فيه خطوات.
    [one] فيه خطوة واحدة.
    [two] فيه خطوتان.
    [few] فيه { $count } خطوات.
    [many] فيه { $count } خطوة.
   *[other] فيه { $count } خطوة.
  }
desk-address = العنوان
desk-which-network = في أي شبكة أجهزة التلاميذ؟
desk-networks = هذا الحاسوب متصل بعدة شبكات. وعناوين أجهزة التلاميذ لها البداية نفسها.
desk-lets-in = هل تسمح لهم الشبكة بالدخول؟
desk-scan = امسح هذا الرمز بهاتف متصل بشبكة التلاميذ، أو افتح { $address }
desk-finds-nothing = إذا لم يجد الهاتف شيئًا في هذا العنوان فالشبكة تعزل الأجهزة بعضها عن بعض: استخدم نقطة اتصال هذا الحاسوب.

desk-tried-in-vain = جهاز: لا يستطيع المشاركة؛ وهو يذكر السبب.
desk-tried = جهاز: كل شيء على ما يرام، ⁦{ $ms } ms⁩، عدد الصور في الثانية { $rate }
desk-tried-doubts = جهاز: يعمل، ويذكر ما يجب الانتباه إليه، ⁦{ $ms } ms⁩، عدد الصور في الثانية { $rate }
desk-projector = اعرض شاشة العرض بجهاز العرض
desk-open-wall = فتح شاشة العرض
desk-way-in = تعرض الشاشة هذا أيضًا بحجم كبير: فمنه يدخل التلاميذ.

desk-files = إجابات من ملفات
desk-from-files = من تلاميذ كان الدرس لديهم في ملف: تُعدّ إجابات متأخرة، كل منها مرة واحدة.
desk-lesson-file = حفظ الدرس في ملف لهم
desk-their-files = ملفاتهم
desk-codes = أو نص رموز QR الخاصة بهم، من ماسح أو باللصق
desk-take = إضافة
desk-file-too-long = هذا الملف أطول من أن يكون إجابات لدرس.
desk-brought = { $name }: { $count ->
    [zero] لا إجابات
    [one] إجابة واحدة
    [two] إجابتان
    [few] { $count } إجابات
    [many] { $count } إجابة
   *[other] { $count } إجابة
  }.
desk-brought-known = { $name }: { $count ->
    [zero] لا إجابات
    [one] إجابة واحدة
    [two] إجابتان
    [few] { $count } إجابات
    [many] { $count } إجابة
   *[other] { $count } إجابة
  }، منها { $known } أُضيف من قبل.
desk-brought-goals = { $count ->
    [one] بحسب ما في الملف تحقق هدف الخطوة { $steps }.
    [two] بحسب ما في الملف تحقق هدفا الخطوتين { $steps }.
    [few] بحسب ما في الملف تحققت أهداف الخطوات { $steps }.
    [many] بحسب ما في الملف تحققت أهداف الخطوات { $steps }.
   *[other] بحسب ما في الملف تحققت أهداف الخطوات { $steps }.
  }

desk-count-handed-in = { $count ->
    [zero] سلّموا
    [one] سلّم
    [two] سلّما
    [few] سلّموا
    [many] سلّموا
   *[other] سلّموا
  }
desk-count-trying = { $count ->
    [zero] يجرّبون
    [one] يجرّب
    [two] يجرّبان
    [few] يجرّبون
    [many] يجرّبون
   *[other] يجرّبون
  }
desk-count-exploded = { $count ->
    [zero] انفجرت أجسامهم
    [one] انفجر جسمه
    [two] انفجر جسماهما
    [few] انفجرت أجسامهم
    [many] انفجرت أجسامهم
   *[other] انفجرت أجسامهم
  }
desk-count-idle = { $count ->
    [zero] لم يغيّروا شيئًا
    [one] لم يغيّر شيئًا
    [two] لم يغيّرا شيئًا
    [few] لم يغيّروا شيئًا
    [many] لم يغيّروا شيئًا
   *[other] لم يغيّروا شيئًا
  }

desk-chose = ما اختاروه
  .now = ما اختاروه حتى الآن
desk-sealed = لا يرى هذا غيرك
desk-most = عدد من اختاروا «{ $choice }» هو { $count }: اسأل أحدهم عن السبب.
desk-predicted = عدد من سحبوا توقعًا: { $count }.
  .some = عدد من سحبوا توقعًا: { $count } من { $all }.
desk-found = ما وجدوه حتى الآن

desk-who = من هنا
desk-who-away = { $here }؛ غير المتصلين: { $away }
desk-nobody = لا أحد بعد.
desk-name-two = { $name } (اثنان)
desk-two = اثنان
desk-away = غير متصل
desk-follows = يشاهد جسمك
desk-done = الخطوات المنجزة: { $done } من { $steps }
desk-moving = يتحرك
desk-untouched = دون لمس
desk-at-rest = ساكن
desk-paused = متوقف مؤقتًا
desk-exploded = انفجر
desk-goal-reached = تحقق الهدف
desk-on-wall = على الشاشة
desk-has-predicted = سلّم توقعًا
desk-has-answered = أجاب
desk-hand = اليد مرفوعة
desk-lower-hands = إنزال الأيدي
desk-to-wall = العرض على الشاشة
desk-off-wall = الإزالة من الشاشة
desk-reset-one = إعادة ضبط هذا
desk-to-all = العودة إلى الجميع
desk-move = النقل إلى جهاز آخر
desk-move-digits = على الجهاز الآخر: { $digits }
desk-move-how = ادخل هناك، واختر «هذا المقعد» واكتب { $digits }.
desk-remove = إزالة
  .confirm = هل تغلق مقعد { $name }؟ سيضيع أيضًا ما قدّمه.

desk-work = ما سُلّم: { $count }
desk-lines = السطور: { $count }
desk-predictions = التوقعات: { $count }
desk-gave = قدّم: { $what }
desk-by = { $name }: { $what }
desk-a-prediction = توقع
desk-a-run = محاولة
desk-late = { $what } (متأخر)
desk-doubt = { $what }: { $doubt }
desk-star = عرض هذا السطر على الشاشة، الكاتب: { $name }
desk-show-body = عرض جسم { $name } على الشاشة
desk-show-prediction = عرض توقع { $name } وحده على الشاشة

desk-not-possible = هذا غير ممكن
desk-cannot-begin = لا يمكن أن تبدأ هذه الخطوة
desk-no-zip = تعذّر إنشاء ملف zip
desk-no-file = تعذّر إنشاء ملف الدرس
desk-no-sheet = تعذّر إنشاء الورقة
desk-the-run = المحاولة
desk-unkept-title = لا يجري حفظ الحصة
desk-unkept = { $reason }. ما يقدّمه التلاميذ الآن ينتظر في صفحاتهم، ويضيع إذا أُغلقت. وفّر مساحة على قرص الحاسوب الذي تجري عليه الحصة، أو احفظ ملف zip الآن.
desk-kept-title = يجري حفظ الحصة من جديد
desk-kept = كل ما قُدّم محفوظ على القرص.
desk-goes-on-title = الحصة مستمرة
desk-goes-on = لا يمكن حذف مجلدها { $folder }: { $reason }.
class-refuse-no-body = ليس لهذا المقعد جسم خاص به الآن.
class-refuse-no-replay = لا يوجد تشغيل لمشاهدته من جديد.
class-refuse-replay-broken = لا يمكن مشاهدة التشغيل من جديد: { $reason }.
class-refuse-classes = الحد الأقصى لعدد الحصص على الخادم { $most }.
class-refuse-scenes = الحد الأقصى لعدد خطوات الحصة { $most }؛ وعددها في هذه المشاهد { $steps }.
class-refuse-no-code = هذا ليس رمز إجابات: فهو يبدأ بـ SR1 ويتكون من حروف وأرقام.
class-refuse-no-file = ليس في هذا الملف إجابات لدرس.
class-refuse-misread = قُرئ الرمز وفيه حرف خطأ: امسحه من جديد.
class-refuse-other-steps = هذه الإجابات لدرس له عدد آخر من الخطوات.
class-refuse-empty = لا توجد فيه إجابة بعد.
class-refuse-other-lesson = هذه الإجابات لدرس غير درس هذه الحصة.

class-doubt-begins = يبدأ السجل بما يلي: { $what }.
class-doubt-goes-on = يتابع السجل بما يلي: { $what }.
class-doubt-begins-other = يبدأ السجل بمشهد غير مشهد الخطوة.
class-doubt-goes-on-other = يتابع السجل بمشهد غير مشهد الخطوة.
class-doubt-sets = يضبط السجل { $what }، وليس لذلك منزلق في هذه الخطوة.
class-doubt-never = يتابع السجل من حيث لم يكن الجسم قط؛ ابدأ من جديد وسلّم تلك المحاولة.
class-doubt-long = في السجل أكثر من { $what }.

zip-readme = 
    ما قدّمه صف: { $steps ->
        [zero] لا خطوات
        [one] خطوة واحدة
        [two] خطوتان
        [few] { $steps } خطوات
        [many] { $steps } خطوة
       *[other] { $steps } خطوة
      }، { $seats ->
        [zero] لا مقاعد
        [one] مقعد واحد
        [two] مقعدان
        [few] { $seats } مقاعد
        [many] { $seats } مقعدًا
       *[other] { $seats } مقعد
      }.

    answers.csv      الأصوات والسطور وما سُلّم، لكل منها صف
    found.csv        ما وُجد وما ضُبط له، لكل محاولة صف
    predictions.csv  حيث تُوقّع أن تكون الكتل، بوحدات المشهد، لكل كتلة صف
    scenes/          ما مرّت به الحصة؛ الأمر ⁦`softrod class scenes/*.json`⁩ يمرّ به مع صف آخر
    logs/            المحاولات التي سُلّمت؛ الأمر ⁦`softrod run --inputs FILE`⁩ يعيد واحدة منها
    pictures/        كيف كانت الأجسام عند تسليمها

    في الجداول فاصلة عشرية نقطية، وبين الأعمدة فواصل.

    { $names } عند إنهاء الحصة لا يبقى شيء من هذا على الحاسوب الذي جرت عليه.
zip-typed-names = لبعض المقاعد أسماء كتبها التلاميذ.
zip-given-names = للمقاعد الأسماء التي أعطتها الحصة.

zip-step = الخطوة
zip-title = العنوان
zip-asked = السؤال
zip-seat = المقعد
zip-name = الاسم
zip-pupil = التلميذ
zip-kind = النوع
zip-answer = الإجابة
zip-right = صحيح
zip-late = متأخر
zip-starred = عليه نجمة
zip-over = بدلالة
zip-over-unit = وحدة ما هو بدلالته
zip-setting = الإعداد
zip-what = الكمية
zip-unit = الوحدة
zip-found = القيمة
zip-doubt = الشك
zip-mass = الكتلة
zip-x = x
zip-y = y

zip-vote = صوت
zip-line = سطر
zip-work = مُسلَّم
zip-yes = نعم
zip-no = لا
