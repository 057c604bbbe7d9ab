race-strip = السباق
race-rule = ينطلق الجميع معًا على أرض هذا الجسم، ويُحتسب منتصف كل جسم عند خط النهاية. يُسمح بتغيير هذا الجسم والأرض، ويُذكر ذلك هنا؛ و«سباق من جديد» يجعله عادلًا.
race-choose = سباق مع
    .paste = الصق رابطًا، أو اختر من الأسفل
    .link = رابط المشهد الذي تتسابق معه
    .go = سباق
race-start = انطلاق
    .hint = الجميع من خط البداية، بعد عدّ تنازلي
    .again = سباق من جديد
race-add = إضافة
    .hint = ينضم جسم آخر إلى السباق
race-leave = مغادرة
    .hint = مغادرة السباق؛ ويتابع هذا الجسم وحده
race-go = انطلق!
race-begins = سباق مع { $names }. { $start }.
race-left = غادرت السباق
race-own = { $name } (جسمك)
race-other = { $name } (الآخر)
race-yours = جسمك

race-at-start = عند خط البداية
race-so-far = { $verdict }، بعد ⁦{ $seconds } s⁩
race-unfair = { $verdict }؛ وقد جرى تغيير أو تحريك في الطريق
race-ahead = { $own ->
    [yes] جسمك متقدم
   *[no] { $name } متقدم
}
race-ahead-by = { $own ->
    [yes] جسمك متقدم بمسافة { $distance }
   *[no] { $name } متقدم بمسافة { $distance }
}
race-close = لا أحد منهما متقدم
    .many = لا أحد متقدم
race-is-first = { $own ->
    [yes] جسمك هو الأول، بعد ⁦{ $seconds } s⁩
   *[no] { $name } هو الأول، بعد ⁦{ $seconds } s⁩
}
race-was-first = { $own ->
    [yes] كان جسمك الأول، بعد ⁦{ $seconds } s⁩
   *[no] كان { $name } الأول، بعد ⁦{ $seconds } s⁩
}
race-alone = { $own ->
    [yes] كان جسمك الأول؛ { $fates }
   *[no] كان { $name } الأول؛ { $fates }
}
race-won = { $own ->
    [yes] كان جسمك الأول، بفارق ⁦{ $seconds } s⁩
   *[no] كان { $name } الأول، بفارق ⁦{ $seconds } s⁩
}
race-won-before = { $own ->
    [yes] كان جسمك الأول، قبل { $next } بمقدار ⁦{ $seconds } s⁩
   *[no] كان { $name } الأول، قبل { $nextOwn ->
        [yes] جسمك
       *[no] { $next }
    } بمقدار ⁦{ $seconds } s⁩
}
race-both = كلاهما معًا، بعد ⁦{ $seconds } s⁩
race-several = { $names } معًا، بعد ⁦{ $seconds } s⁩
race-nobody = لم يكن أحد الأول: { $fates }
race-exploded = { $who ->
    [first] انفجر جسمك
    [own] انفجر جسمك
    [both] انفجر كلاهما
    [all] انفجرت كلها
   *[other] انفجر { $name }
}
race-fell = { $who ->
    [first] سقط جسمك
    [own] سقط جسمك
    [both] سقط كلاهما
    [all] سقطت كلها
   *[other] سقط { $name }
}
race-away = { $who ->
    [first] سار جسمك في الاتجاه الآخر
    [own] سار جسمك في الاتجاه الآخر
    [both] سار كلاهما في الاتجاه الآخر
    [all] سارت كلها في الاتجاه الآخر
   *[other] سار { $name } في الاتجاه الآخر
}
race-misfit = { $who ->
    [first] جسمك لا يناسب هذه الأرض
    [own] جسمك لا يناسب هذه الأرض
    [both] كلاهما لا يناسب هذه الأرض
    [all] كلها لا تناسب هذه الأرض
   *[other] { $name } لا يناسب هذه الأرض
}
race-late = { $who ->
    [first] احتاج جسمك إلى أكثر من ⁦{ $limit } s⁩
    [own] احتاج جسمك إلى أكثر من ⁦{ $limit } s⁩
    [both] احتاج كلاهما إلى أكثر من ⁦{ $limit } s⁩
    [all] احتاجت كلها إلى أكثر من ⁦{ $limit } s⁩
   *[other] احتاج { $name } إلى أكثر من ⁦{ $limit } s⁩
}

race-finish = خط النهاية، { $way }
race-to = إلى الأمام بمسافة { $distance }
    .behind = إلى الوراء بمسافة { $distance }
race-named = { $name }، { $way }

race-full = الحد الأقصى لعدد الأجسام في السباق { $count }
race-unknown = { $text } ليس رابط مشهد ولا اسم مشهد
