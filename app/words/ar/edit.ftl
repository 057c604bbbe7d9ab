edit-tools = التعديل
edit-bar = ما هو محدد
edit-waits-build = المس لإضافة كتلة، واسحب لإضافة نابض
edit-waits-joint = المس كتلة، ثم زاوية عندها
edit-waits-select = المس جزءًا، أو اسحب حول عدة أجزاء
edit-waits-cut = اسحب عبر النوابض لقطعها
edit-paste = لصق
edit-done = تم
edit-rests = سكون ما نُقل
    .hint = تأخذ نوابض ما نُقل ومفاصله أطوالها وزواياها الجديدة أطوالًا وزوايا طبيعية، أو تحتفظ بالسابقة
edit-stiffen = الحفاظ عليه بصلابة ⁦× { $times }⁩

edit-undo = تراجع عن: { $what }
    .none = لا شيء للتراجع عنه
    .done = جرى التراجع عن: { $what }
edit-redo = إعادة: { $what }
    .none = لا شيء لإعادته

edit-masses = { $count ->
    [zero] لا كتل
    [one] كتلة واحدة
    [two] كتلتان
    [few] { $count } كتل
    [many] { $count } كتلة
   *[other] { $count } كتلة
}
edit-springs = { $count ->
    [zero] لا نوابض
    [one] نابض واحد
    [two] نابضان
    [few] { $count } نوابض
    [many] { $count } نابضًا
   *[other] { $count } نابض
}
edit-joints = { $count ->
    [zero] لا مفاصل
    [one] مفصل واحد
    [two] مفصلان
    [few] { $count } مفاصل
    [many] { $count } مفصلًا
   *[other] { $count } مفصل
}
edit-parts = { $count ->
    [zero] لا أجزاء
    [one] جزء واحد
    [two] جزآن
    [few] { $count } أجزاء
    [many] { $count } جزءًا
   *[other] { $count } جزء
}
edit-mass = الكتلة { $number }
edit-spring = النابض { $number }
edit-joint = المفصل { $number }
edit-selected = المحدد: { $parts }
    .none = لا شيء محدد
edit-open = الأدوات مفتوحة: { $tool }
    .closed = الأدوات مغلقة
edit-begins = يبدأ نابض عند الكتلة { $mass }: مفتاح الإدخال عند كتلة أخرى يصلهما ويتابع من هناك، وEsc ينهيه
    .ended = أُلغي النابض
edit-cross = علامة التقاطع عند { $place }. الأسهم تحركها، ومع Shift بعُشر الخطوة؛ الإدخال يضغط هناك، وEsc يزيلها
    .gone = أُزيلت علامة التقاطع
edit-cross-on = { $place }: { $part }
edit-rests-at = الزاوية الطبيعية { $angle }
edit-moved = كتل منقولة
    .text = يمكن أن تسكن نوابض ما نقلته ومفاصله كما هي الآن، أو أن تحتفظ بأطوالها الطبيعية وزواياها الطبيعية: عندئذٍ تشدّه إلى الوراء حالما يبدأ التشغيل.
    .take = أخذ الأطوال الجديدة
    .keep = الاحتفاظ بالأطوال الطبيعية
    .once = يُسأل هذا مرة واحدة. ويغيّره الزر «سكون ما نُقل».
edit-texts = اسم هذا المشهد ووصفه
    .name = الاسم
    .description = ما يعرضه
    .done = تم
    .cancel = إلغاء
edit-picture = صورة
    .hint = صورة خلف الجسم للرسم فوقها؛ وتبقى في هذا المتصفح
    .size = الحجم
    .opacity = العتامة
    .move = تحريكها
    .drag = اسحبها، أو استخدم مفاتيح الأسهم، حتى تضغط Esc
    .another = صورة أخرى
    .remove = إزالتها
edit-no-picture = { $name } ليس صورة يستطيع هذا المتصفح عرضها

edit-not-pasted = لا يمكن لصق هذا
edit-not-copied = لا يمكن نسخ هذا
edit-sags = هل يتدلّى؟
    .text = اضغط «إعادة الضبط»، ثم «الحفاظ على هذا الشكل» إلى جانب الأدوات: يبقى الجسم كما رسمته.

number-mixed = قيم مختلفة
number-middle = الوسط
number-note = { $number } ({ $note })
number-proportions = الحفاظ على النسب
    .hint = عندئذٍ يحدد العدد أكبر قيمة، وتتغير القيم الأخرى بالنسبة نفسها
number-holding = الكتل
    .pin = تثبيت
    .release = تحرير
number-rest = السكون كما هو الآن
    .hint = تصبح الأطوال الطبيعية والزوايا الطبيعية مساوية للحالية
number-delete = حذف
number-position-x = البداية x
number-position-y = البداية y
number-mass = الكتلة
number-radius = نصف القطر
number-force-x = القوة x
number-force-y = القوة y
number-spring-stiffness = الصلابة
number-spring-damping = التخميد
number-spring-rest-length = الطول الطبيعي
number-spring-strength = المتانة
number-spring-yield-force = قوة الخضوع
number-spring-hardening = التصلّد
number-joint-stiffness = صلابة المفصل
number-joint-damping = تخميد المفصل
number-joint-rest-angle = الزاوية الطبيعية
number-joint-yield-torque = عزم الخضوع
number-spring-muscle-amplitude = سعة العضلة
number-spring-muscle-phase = طور العضلة
number-spring-muscle-per-beat = عدد موجات العضلة في دورة الإيقاع
number-joint-muscle-amplitude = سعة عضلة المفصل
number-joint-muscle-phase = طور عضلة المفصل
number-joint-muscle-per-beat = عدد موجات عضلة المفصل في دورة الإيقاع
number-joint-motor-speed = سرعة المحرك
number-joint-motor-torque = عزم دوران المحرك

way-touch = الكتل تلامس
    .hint = الكرات تتصادم: يرتد بعضها عن بعض، وترتد عن النوابض حيث يوجد تلامس
    .usual = لا كتل أخرى
    .solid = كرات أخرى
way-move = الكتل تتحرك
    .hint = الكتلة على السكة لا تتحرك إلا على امتدادها، مثل عربة
    .usual = بحرية
    .level = ذهابًا وإيابًا على سكة
    .upright = صعودًا وهبوطًا على سكة
way-springs = النوابض تؤثر
    .hint = الحبل يشدّ فقط، والمصدّ يؤثر في جانب واحد من زاويته الطبيعية
    .usual = في الاتجاهين
    .pull = بالشدّ فقط
    .push = بالدفع فقط
way-joints = المفاصل تؤثر
    .hint = { way-springs.hint }
    .usual = في الجانبين
    .above = فوق زاويتها الطبيعية فقط
    .below = تحت زاويتها الطبيعية فقط
way-turn = المفاصل تدور
    .hint = يدير المحرك النابض الثاني للمفصل بالنسبة إلى الأول
    .usual = بحرية
    .motor = بمحرك
    .left-right = بمحرك، بمفتاحي السهمين الأيسر والأيمن
    .up-down = بمحرك، بمفتاحي السهمين العلوي والسفلي
way-forces = القوى تؤثر
    .hint = تؤثر القوة في الكتلة دائمًا، أو ما دام أحد مفاتيح الأسهم مضغوطًا
    .usual = دائمًا
    .left-right = بمفتاحي السهمين الأيسر والأيمن
    .up-down = بمفتاحي السهمين العلوي والسفلي
way-muscles = العضلات تعمل
    .hint = تعمل العضلة دائمًا، أو ما دام أحد مفاتيح الأسهم مضغوطًا؛ أما التي تعمل باطراد فتبقى بعد ذلك كما هي
    .usual = على الإيقاع
    .left-right = على الإيقاع، بمفتاحي السهمين الأيسر والأيمن
    .up-down = على الإيقاع، بمفتاحي السهمين العلوي والسفلي
    .steady-left-right = باطراد، بمفتاحي السهمين الأيسر والأيمن
    .steady-up-down = باطراد، بمفتاحي السهمين العلوي والسفلي
way-joint-muscles = عضلات المفاصل تعمل
    .hint = { way-muscles.hint }
    .usual = { way-muscles.usual }
    .left-right = { way-muscles.left-right }
    .up-down = { way-muscles.up-down }
    .steady-left-right = { way-muscles.steady-left-right }
    .steady-up-down = { way-muscles.steady-up-down }

done-masses-removed = { $count ->
    [zero] دون حذف كتل
    [one] حذف كتلة واحدة
    [two] حذف كتلتين
    [few] حذف { $count } كتل
    [many] حذف { $count } كتلة
   *[other] حذف { $count } كتلة
}
done-springs-removed = { $count ->
    [zero] دون حذف نوابض
    [one] حذف نابض واحد
    [two] حذف نابضين
    [few] حذف { $count } نوابض
    [many] حذف { $count } نابضًا
   *[other] حذف { $count } نابض
}
done-joints-removed = { $count ->
    [zero] دون حذف مفاصل
    [one] حذف مفصل واحد
    [two] حذف مفصلين
    [few] حذف { $count } مفاصل
    [many] حذف { $count } مفصلًا
   *[other] حذف { $count } مفصل
}
done-muscles-removed = { $count ->
    [zero] دون حذف عضلات
    [one] حذف عضلة واحدة
    [two] حذف عضلتين
    [few] حذف { $count } عضلات
    [many] حذف { $count } عضلة
   *[other] حذف { $count } عضلة
}
done-springs-cut = { $count ->
    [zero] دون قطع نوابض
    [one] قطع نابض واحد
    [two] قطع نابضين
    [few] قطع { $count } نوابض
    [many] قطع { $count } نابضًا
   *[other] قطع { $count } نابض
}
done-springs-added = { $count ->
    [zero] دون إضافة نوابض
    [one] إضافة نابض واحد
    [two] إضافة نابضين
    [few] إضافة { $count } نوابض
    [many] إضافة { $count } نابضًا
   *[other] إضافة { $count } نابض
}
done-joints-added = { $count ->
    [zero] دون إضافة مفاصل
    [one] إضافة مفصل واحد
    [two] إضافة مفصلين
    [few] إضافة { $count } مفاصل
    [many] إضافة { $count } مفصلًا
   *[other] إضافة { $count } مفصل
}
done-muscles-added = { $count ->
    [zero] دون إضافة عضلات
    [one] إضافة عضلة واحدة
    [two] إضافة عضلتين
    [few] إضافة { $count } عضلات
    [many] إضافة { $count } عضلة
   *[other] إضافة { $count } عضلة
}
done-masses-pinned = { $count ->
    [zero] دون تثبيت كتل
    [one] تثبيت كتلة واحدة
    [two] تثبيت كتلتين
    [few] تثبيت { $count } كتل
    [many] تثبيت { $count } كتلة
   *[other] تثبيت { $count } كتلة
}
done-masses-let-go = { $count ->
    [zero] دون تحرير كتل
    [one] تحرير كتلة واحدة
    [two] تحرير كتلتين
    [few] تحرير { $count } كتل
    [many] تحرير { $count } كتلة
   *[other] تحرير { $count } كتلة
}
done-masses-moved = { $count ->
    [zero] دون نقل كتل
    [one] نقل كتلة واحدة
    [two] نقل كتلتين
    [few] نقل { $count } كتل
    [many] نقل { $count } كتلة
   *[other] نقل { $count } كتلة
}
done-masses-mirrored = { $count ->
    [zero] دون عكس كتل
    [one] عكس كتلة واحدة
    [two] عكس كتلتين
    [few] عكس { $count } كتل
    [many] عكس { $count } كتلة
   *[other] عكس { $count } كتلة
}
done-masses-duplicated = { $count ->
    [zero] دون مضاعفة كتل
    [one] مضاعفة كتلة واحدة
    [two] مضاعفة كتلتين
    [few] مضاعفة { $count } كتل
    [many] مضاعفة { $count } كتلة
   *[other] مضاعفة { $count } كتلة
}
done-masses-pasted = { $count ->
    [zero] دون لصق كتل
    [one] لصق كتلة واحدة
    [two] لصق كتلتين
    [few] لصق { $count } كتل
    [many] لصق { $count } كتلة
   *[other] لصق { $count } كتلة
}
done-muscles-moved = { $count ->
    [zero] دون نقل عضلات
    [one] نقل عضلة واحدة
    [two] نقل عضلتين
    [few] نقل { $count } عضلات
    [many] نقل { $count } عضلة
   *[other] نقل { $count } عضلة
}
done-muscles-changed = { $count ->
    [zero] دون تغيير عضلات
    [one] تغيير عضلة واحدة
    [two] تغيير عضلتين
    [few] تغيير { $count } عضلات
    [many] تغيير { $count } عضلة
   *[other] تغيير { $count } عضلة
}
done-muscles-spread = { $count ->
    [zero] دون توزيع عضلات
    [one] توزيع عضلة واحدة
    [two] توزيع عضلتين
    [few] توزيع { $count } عضلات
    [many] توزيع { $count } عضلة
   *[other] توزيع { $count } عضلة
}
done-springs-critically-damped = { $count ->
    [zero] تخميد حرج دون نوابض
    [one] تخميد حرج: نابض واحد
    [two] تخميد حرج: نابضان
    [few] تخميد حرج: { $count } نوابض
    [many] تخميد حرج: { $count } نابضًا
   *[other] تخميد حرج: { $count } نابض
}
done-triangulated-springs-added = { $count ->
    [zero] تقسيم إلى مثلثات دون إضافة نوابض
    [one] تقسيم إلى مثلثات بإضافة نابض واحد
    [two] تقسيم إلى مثلثات بإضافة نابضين
    [few] تقسيم إلى مثلثات بإضافة { $count } نوابض
    [many] تقسيم إلى مثلثات بإضافة { $count } نابضًا
   *[other] تقسيم إلى مثلثات بإضافة { $count } نابض
}
done-mass-added = إضافة كتلة
done-mass-and-spring-added = إضافة كتلة ونابض
done-masses-and-a-spring-added = { $count ->
    [zero] إضافة نابض
    [one] إضافة كتلة واحدة ونابض
    [two] إضافة كتلتين ونابض
    [few] إضافة { $count } كتل ونابض
    [many] إضافة { $count } كتلة ونابض
   *[other] إضافة { $count } كتلة ونابض
}
done-nothing-removed = دون حذف أي شيء
done-nothing-mirrored = دون عكس أي شيء
done-rest-as-it-is = السكون كما هو الآن
done-keep-this-shape = الحفاظ على هذا الشكل
done-fitted = ملاءمة المشهد
done-scene-renamed = تغيير اسم المشهد
done-scene-described = تغيير وصف المشهد
done-mode = نمط الاهتزاز { $count }
done-own-values-of-the-body = القيم الأصلية للجسم
done-own-values-of-the-solver = القيم الأصلية للحساب
done-number-set = ضبط { $number }: { $parts }
done-number-scaled = تغيير { $number } بنسبة واحدة: { $parts }
done-way = { $way }: { $choice }
done-lesson-deleted = حذف الدرس
done-step-added = إضافة الخطوة { $count }
done-step-duplicated = مضاعفة الخطوة { $count }
done-step-removed = حذف الخطوة { $count }
done-step-moved = نقل «{ $title }» لتصبح الخطوة { $count }
done-beginning-of-step = بداية الخطوة { $count }
done-title-of-step = عنوان الخطوة { $count }
done-task-of-step = مهمة الخطوة { $count }
done-what-to-watch-of-step = ما يُلاحظ في الخطوة { $count }
done-question-of-step = سؤال الخطوة { $count }
done-prediction-of-step = توقع الخطوة { $count }
done-goal-of-step = هدف الخطوة { $count }
done-what-is-handed-in-of-step = ما يُسلَّم في الخطوة { $count }
done-sliders-of-step = منزلقات الخطوة { $count }
done-plots-of-step = الرسوم البيانية للخطوة { $count }
done-arrows-of-step = أسهم الخطوة { $count }
done-second-body-of-step = الجسم الثاني للخطوة { $count }
done-run-of-step = تشغيل الخطوة { $count }

edit-no-corner = لا توجد زاوية بلا نابض زاوي
edit-no-brace = لم يبقَ شيء لتقسيمه إلى مثلثات
edit-no-selection = لا شيء محدد
edit-no-move = لا شيء مما هو محدد يمكن نقله
