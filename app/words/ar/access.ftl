access-title = سهولة الوصول واللغة
access-language = اللغة
    .hint = لغة الصفحة؛ أما المشاهد التي كتبتها أنت فتبقى بلغتها. ويبقى الجسم محفوظًا ومعه ما يمكن التراجع عنه.
access-letters = الحروف كمفاتيح
    .hint = لمن يُملون نصوصهم بالصوت أو يضغطون المفاتيح خطأً. أما المفاتيح مع Ctrl والأسهم وEsc فتعمل دائمًا.
    .always = دائمًا
    .body = عندما يكون التركيز على الجسم
    .never = أبدًا
access-taps = النقر بدل السحب
    .hint = انقر الشيء ثم المكان الذي يذهب إليه. مفتاح Esc أو نقرة أخرى على الشيء تعيده إلى مكانه. ويبقى السحب ممكنًا.
access-larger = أكبر
    .hint = كل شيء أكبر وبخط أعرض.
access-contrast = تباين أعلى
    .hint = تبرز الحروف والحواف أكثر.
access-still = حركة أقل
    .hint = لا تتحرك الرياح والمشاهد والعلامات من تلقاء نفسها. أما الجسم فيتحرك عند تشغيله.
access-sound = الصوت
    .hint = صوت الرسوم البيانية وأنماط الاهتزاز وما يتلامس وينقطع.
access-events = نطق الأحداث
    .hint = يقول قارئ الشاشة بكلمات قليلة ما يحدث: ما ينقطع أو يلامس أو يسكن أو يُمسك أو يُفلت. جملة واحدة على الأكثر كل ثانيتين.
access-kept = يحتفظ هذا الجهاز بهذه الإعدادات.

# While something is picked up by a tap, and after that; $thing is one of the names below, or that of an instrument, a
# bar or a mark.
taps-held = تم الالتقاط: { $thing }. انقر المكان الذي يذهب إليه. مفتاح Esc أو نقرة عليه تعيده إلى مكانه.
taps-put = تم الوضع: { $thing }
taps-back = تمت الإعادة إلى المكان: { $thing }
taps-nothing = لا يوجد هنا ما يُلتقط؛ إيقاف الجسم مؤقتًا يسهّل النقر عليه.
taps-button = إعادة إلى المكان
taps-selection = التحديد
taps-frame = ركن الإطار
taps-cut = نهاية القطع
taps-turn = الزاوية الطبيعية للمفصل
taps-picture = صورة
# Of a plot: the end of the part of the time that is to be shown larger.
taps-part = نهاية الجزء المراد تكبيره
