modes-strip = أنماط الاهتزاز
modes-close = إغلاق أنماط الاهتزاز
    .hint = إغلاق
modes-how = أشر إلى عمود، أو انتقل إليه بمفتاح Tab، لترى شكله. ارفعه فيتذبذب الجسم على هذا النحو. واستمر في الضغط عليه أو على المسافة فيُثار النمط.
modes-looking = جارٍ البحث عن أنماط الاهتزاز.
modes-none = لا أنماط اهتزاز: { $why }.
modes-still = لا يهتز حول وضعية سكونه
modes-shown = تظهر أنماط الاهتزاز فوق شريط الزمن
modes-reading = { $swings ->
    [no] النمط { $number }: ⁦{ $frequency } Hz⁩، { $amplitude }، لا يتذبذب، وله { $share } من الطاقة
   *[yes] النمط { $number }: ⁦{ $frequency } Hz⁩، { $amplitude }، التخميد { $damping }، وله { $share } من الطاقة
}
modes-reading-driven = { $swings ->
    [no] النمط { $number }: ⁦{ $frequency } Hz⁩، { $amplitude }، لا يتذبذب، مُثار
   *[yes] النمط { $number }: ⁦{ $frequency } Hz⁩، { $amplitude }، التخميد { $damping }، مُثار
}
modes-others = خارج هذه كلها: أنماط أسرع، وما تزيد به الحركة الكبيرة على الحركات الصغيرة: { $share } من الطاقة
    .lacks = خارج هذه كلها: أنماط أسرع، وما تزيد به الحركة الكبيرة على الحركات الصغيرة؛ ولو كانت الأنماط وحدها لزادت الطاقة بمقدار { $share }
    .word = غيرها
modes-share = ⁦{ $percent } %⁩
    .least = أقل من ⁦0.1 %⁩
modes-bar = النمط { $number }، { $frequency } هرتز
    .others = خارج كل الأنماط
modes-value = { $amplitude }، { $share } من الطاقة
modes-driven = النمط { $number } مُثار
modes-level = النمط { $number }: { $percent } في المئة من عمود كامل
modes-volume = شدة الصوت
modes-sound = صوت أنماط الاهتزاز
    .on = الصوت: مفعّل
    .off = الصوت: معطّل
