describe-mass = { $count ->
    [zero] لا كتل منفردة.
    [one] كتلة منفردة واحدة.
    [two] كتلتان منفردتان.
    [few] { $count } كتل منفردة.
    [many] { $count } كتلة منفردة.
   *[other] { $count } كتلة منفردة.
}
describe-chain = { $count ->
    [zero] { $count } سلاسل، في كل منها
    [one] سلسلة واحدة فيها
    [two] سلسلتان، في كل منهما
    [few] { $count } سلاسل، في كل منها
    [many] { $count } سلسلة، في كل منها
   *[other] { $count } سلسلة، في كل منها
} { $masses ->
    [zero] لا كتل
    [one] كتلة واحدة
    [two] كتلتان
    [few] { $masses } كتل
    [many] { $masses } كتلة
   *[other] { $masses } كتلة
} و{ $springs ->
    [zero] لا نوابض
    [one] نابض واحد
    [two] نابضان
    [few] { $springs } نوابض
    [many] { $springs } نابضًا
   *[other] { $springs } نابض
} و{ $joints ->
    [zero] لا مفاصل
    [one] مفصل واحد
    [two] مفصلان
    [few] { $joints } مفاصل
    [many] { $joints } مفصلًا
   *[other] { $joints } مفصل
}.
describe-ring = { $count ->
    [zero] { $count } حلقات، في كل منها
    [one] حلقة واحدة فيها
    [two] حلقتان، في كل منهما
    [few] { $count } حلقات، في كل منها
    [many] { $count } حلقة، في كل منها
   *[other] { $count } حلقة، في كل منها
} { $masses ->
    [zero] لا كتل
    [one] كتلة واحدة
    [two] كتلتان
    [few] { $masses } كتل
    [many] { $masses } كتلة
   *[other] { $masses } كتلة
} و{ $springs ->
    [zero] لا نوابض
    [one] نابض واحد
    [two] نابضان
    [few] { $springs } نوابض
    [many] { $springs } نابضًا
   *[other] { $springs } نابض
} و{ $joints ->
    [zero] لا مفاصل
    [one] مفصل واحد
    [two] مفصلان
    [few] { $joints } مفاصل
    [many] { $joints } مفصلًا
   *[other] { $joints } مفصل
}.
describe-tree = { $count ->
    [zero] { $count } أشجار، في كل منها
    [one] شجرة واحدة فيها
    [two] شجرتان، في كل منهما
    [few] { $count } أشجار، في كل منها
    [many] { $count } شجرة، في كل منها
   *[other] { $count } شجرة، في كل منها
} { $masses ->
    [zero] لا كتل
    [one] كتلة واحدة
    [two] كتلتان
    [few] { $masses } كتل
    [many] { $masses } كتلة
   *[other] { $masses } كتلة
} و{ $springs ->
    [zero] لا نوابض
    [one] نابض واحد
    [two] نابضان
    [few] { $springs } نوابض
    [many] { $springs } نابضًا
   *[other] { $springs } نابض
} و{ $joints ->
    [zero] لا مفاصل
    [one] مفصل واحد
    [two] مفصلان
    [few] { $joints } مفاصل
    [many] { $joints } مفصلًا
   *[other] { $joints } مفصل
}.
describe-net = { $count ->
    [zero] { $count } شبكات، في كل منها
    [one] شبكة واحدة فيها
    [two] شبكتان، في كل منهما
    [few] { $count } شبكات، في كل منها
    [many] { $count } شبكة، في كل منها
   *[other] { $count } شبكة، في كل منها
} { $masses ->
    [zero] لا كتل
    [one] كتلة واحدة
    [two] كتلتان
    [few] { $masses } كتل
    [many] { $masses } كتلة
   *[other] { $masses } كتلة
} و{ $springs ->
    [zero] لا نوابض
    [one] نابض واحد
    [two] نابضان
    [few] { $springs } نوابض
    [many] { $springs } نابضًا
   *[other] { $springs } نابض
} حول { $loops ->
    [zero] لا فتحات
    [one] فتحة واحدة
    [two] فتحتين
    [few] { $loops } فتحات
    [many] { $loops } فتحة
   *[other] { $loops } فتحة
} و{ $joints ->
    [zero] لا مفاصل
    [one] مفصل واحد
    [two] مفصلان
    [few] { $joints } مفاصل
    [many] { $joints } مفصلًا
   *[other] { $joints } مفصل
}.

describe-free = لا شيء يثبّت الجسم.
    .parts = { $count ->
        [one] لا شيء يثبّت هذا الجزء.
       *[other] لا شيء يثبّتها.
    }
describe-held = الكتلة المثبتة هي { $mass }، وهي { $side ->
    [left] عند الطرف الأيسر للجسم
    [right] عند الطرف الأيمن للجسم
    [top] في أعلى الجسم
    [bottom] في أسفل الجسم
    [leftTop] في أعلى يسار الجسم
    [rightTop] في أعلى يمين الجسم
    [leftBottom] في أسفل يسار الجسم
    [rightBottom] في أسفل يمين الجسم
   *[inside] بين طرفي الجسم
}.
    .mass = الكتلة { $mass } مثبّتة.
describe-held-many = عدد الكتل المثبتة { $count }، وهي: { $masses }.
describe-held-most = عدد الكتل المثبتة { $count }.

describe-lies = عرض الجسم { $width } وارتفاعه { $height }.
    .all = عرض الكل معًا { $width } وارتفاعه { $height }.
describe-piece = الجسم رقم { $number } من { $side ->
    [top] الأعلى
   *[left] اليسار
} يتكون من { $count ->
    [one] الكتلة
   *[other] الكتل
} { $masses }.
describe-hangs = أخفض كتلة فيه هي الكتلة { $mass }، وتقع تحت أعلى كتلة مثبتة بمقدار { $depth }.

describe-still = الجسم ساكن.
    .away = الجسم لا يتحرك الآن، وهو على بعد { $length } من موضع سكونه.
    .nearly = الجسم شبه ساكن: يتذبذب بأقل من { $length }.
    .all = لا شيء يتحرك.
describe-moves = أسرع كتلة فيه هي الكتلة { $mass }، وتتحرك { $way } بسرعة { $speed }.
    .all = أسرع كتلة هي الكتلة { $mass }، وتتحرك { $way } بسرعة { $speed }.
describe-drifts = يتحرك الجسم ككل { $whole } بسرعة { $speed }.
describe-turns = يدور { $sense ->
    [clockwise] مع اتجاه عقارب الساعة
   *[counterclockwise] عكس اتجاه عقارب الساعة
} بمعدل { $degrees } درجة في الثانية.
describe-way = { $way ->
    [right] إلى اليمين
    [upRight] إلى أعلى اليمين
    [up] إلى الأعلى
    [upLeft] إلى أعلى اليسار
    [left] إلى اليسار
    [downLeft] إلى أسفل اليسار
    [down] إلى الأسفل
   *[downRight] إلى أسفل اليمين
}

describe-stretched = أكثر النوابض استطالةً هو النابض { $spring }، بنسبة ⁦{ $percent } %⁩.
describe-squeezed = أكثر النوابض انضغاطًا هو النابض { $spring }، بنسبة ⁦{ $percent } %⁩.
describe-touching = { $count ->
    [zero] لا كتلة تلامس شيئًا.
    [one] كتلة واحدة تلامس شيئًا.
    [two] كتلتان تلامسان شيئًا.
    [few] { $count } كتل تلامس شيئًا.
    [many] { $count } كتلة تلامس شيئًا.
   *[other] { $count } كتلة تلامس شيئًا.
}
describe-broken = { $count ->
    [zero] لا نوابض مقطوعة.
    [one] نابض واحد مقطوع.
    [two] نابضان مقطوعان.
    [few] { $count } نوابض مقطوعة.
    [many] { $count } نابضًا مقطوعًا.
   *[other] { $count } نابض مقطوع.
}
describe-yielded = { $count ->
    [zero] لا نوابض ولا مفاصل مشوّهة تشوّهًا دائمًا.
    [one] نابض واحد أو مفصل واحد تشوّه تشوّهًا دائمًا.
    [two] اثنان من النوابض والمفاصل تشوّها تشوّهًا دائمًا.
    [few] { $count } من النوابض والمفاصل تشوّهت تشوّهًا دائمًا.
    [many] { $count } من النوابض والمفاصل تشوّهت تشوّهًا دائمًا.
   *[other] { $count } من النوابض والمفاصل تشوّهت تشوّهًا دائمًا.
}

describe-swings = إذا تُرك وشأنه يتذبذب بزمن دوري قدره ⁦{ $period } s⁩، ويفقد ⁦{ $percent } %⁩ من كل ذبذبة.
describe-swings-on = إذا تُرك وشأنه يتذبذب بزمن دوري قدره ⁦{ $period } s⁩، ولا يكاد يفقد شيئًا.

describe-same = لم يتغير شيء منذ ذلك الحين.
describe-moved = منذ ذلك الحين انتقل { $way } مسافة { $length }.
describe-broke = { $count ->
    [zero] منذ ذلك الحين لم ينقطع أي نابض.
    [one] منذ ذلك الحين انقطع نابض واحد.
    [two] منذ ذلك الحين انقطع نابضان.
    [few] منذ ذلك الحين انقطعت { $count } نوابض.
    [many] منذ ذلك الحين انقطع { $count } نابضًا.
   *[other] منذ ذلك الحين انقطع { $count } نابض.
}
describe-built = منذ ذلك الحين تغيّر بناء الجسم.

describe-part-mass = الكتلة { $mass }، { $weight }، عند x = { $x }، y = { $y }.
describe-part-held = هي مثبتة.
    .hand = هي في يدك.
describe-part-still = هي ساكنة.
describe-part-moves = تتحرك { $way } بسرعة { $speed }.
describe-part-alone = لا يتصل بها أي نابض.
describe-part-joined = { $count ->
    [one] يصلها النابض { $springs } بالكتلة { $masses }.
   *[other] تصلها النوابض { $springs } بالكتل { $masses }.
}
describe-part-joined-most = { $count ->
    [one] يصلها نابض واحد بكتلة أخرى.
    [two] يصلها نابضان بكتل أخرى.
    [few] تصلها { $count } نوابض بكتل أخرى.
    [many] يصلها { $count } نابضًا بكتل أخرى.
   *[other] يصلها { $count } نابض بكتل أخرى.
}
describe-part-touches = تلامس شيئًا.
describe-part-spring = يصل النابض { $spring } بين الكتلتين { $one } و{ $other }.
describe-part-length = طوله { $length }، وطوله الطبيعي { $rest }.
describe-part-strain = هو { $sense ->
    [stretched] مشدود
   *[squeezed] مضغوط
} بنسبة ⁦{ $percent } %⁩.
describe-part-force = { $sense ->
    [pulls] يشد طرفيه أحدهما نحو الآخر
   *[pushes] يدفع طرفيه أحدهما عن الآخر
} بقوة { $force }.
describe-part-broken = هو مقطوع.
describe-part-yielded = تشوّه تشوهًا دائمًا.
describe-part-muscle = هو عضلة تغيّر طوله الطبيعي بنسبة ⁦{ $percent } %⁩ على الأكثر.
describe-part-joint = المفصل { $joint } عند الكتلة { $mass }، بين النابضين { $one } و{ $other }.
describe-part-corner = قياس الزاوية الداخلية بين هذين النابضين { $corner }.
describe-part-angle = زاويته { $angle }، وزاويته الطبيعية { $rest }.
describe-part-torque = عزمه { $torque }.
describe-part-bends = هو عضلة تغيّر زاويته الطبيعية بمقدار { $degrees } على الأكثر.
describe-part-motor = يديره محرك بسرعة { $speed } على الأكثر.

news-broke = { $count ->
    [zero] لم ينقطع أي نابض.
    [one] انقطع نابض واحد.
    [two] انقطع نابضان.
    [few] انقطعت { $count } نوابض.
    [many] انقطع { $count } نابضًا.
   *[other] انقطع { $count } نابض.
}
news-touched = { $by ->
    [floor] الجسم يلامس الأرض.
    [wall] الجسم يلامس جدارًا.
   *[body] الجسم يلامس جسمًا آخر أو نفسه.
}
news-rest = سكن الجسم.
news-exploded = انفجر الجسم وأُوقف.
news-grabbed = الكتلة { $mass } في اليد.
news-dropped = أُفلتت الكتلة { $mass }.
news-running = يعمل.
    .paused = متوقف مؤقتًا.
news-step = الخطوة { $number }: { $title }

describe-title = الوصف
describe-close = إغلاق الوصف
