reading-stretch = استطالة
reading-force = قوة
reading-length = طول
reading-angle = زاوية
reading-torque = عزم دوران
reading-speed = سرعة
reading-vx = السرعة ⁦vx⁩
reading-vy = السرعة ⁦vy⁩
reading-momentum-x = كمية الحركة في اتجاه ⁦x⁩
reading-momentum-y = كمية الحركة في اتجاه ⁦y⁩
reading-distance = مسافة
reading-time-step = الخطوة الزمنية كجزء من حدّها
reading-of = { $owner ->
    [mass] { $what } للكتلة { $number }
    [spring] { $what } للنابض { $number }
    [joint] { $what } للمفصل { $number }
   *[body] { $what } الجسم
  }
reading-period = الزمن الدوري في { $what }
reading-period-of = { $owner ->
    [mass] الزمن الدوري للكتلة { $number }
    [spring] الزمن الدوري للنابض { $number }
    [joint] الزمن الدوري للمفصل { $number }
   *[body] الزمن الدوري للجسم
  }

goal-between = { $reading }: من { $low } إلى { $high }
goal-least = { $reading }: على الأقل { $low }
goal-most = { $reading }: على الأكثر { $high }
goal-held = { $goal }، لمدة ⁦{ $seconds } s⁩

run-choice = { $choice }: { $option }
run-many = { $count ->
    [zero] لا تُسحب أي كتلة جانبًا
    [one] تُسحب كتلة واحدة جانبًا ثم تُترك
    [two] تُسحب كتلتان جانبًا ثم تُتركان
    [few] تُسحب { $count } كتل جانبًا ثم تُترك
    [many] تُسحب { $count } كتلة جانبًا ثم تُترك
   *[other] تُسحب { $count } كتلة جانبًا ثم تُترك
  }
run-pull = تُسحب الكتلة { $mass } مسافة { $way } ثم تُترك
run-way =
  .right = { $length } إلى اليمين
  .left = { $length } إلى اليسار
  .down = { $length } إلى الأسفل
  .up = { $length } إلى الأعلى
run-ways = { $one } و { $other }
run-led = { $count ->
    [one] تُدار الكتلة { $masses } على دائرة نصف قطرها { $radius } بمعدل { $times } دورة في الثانية
    [two] تُدار الكتلتان { $masses } على دائرة نصف قطرها { $radius } بمعدل { $times } دورة في الثانية
    [few] تُدار الكتل { $masses } على دائرة نصف قطرها { $radius } بمعدل { $times } دورة في الثانية
    [many] تُدار الكتل { $masses } على دائرة نصف قطرها { $radius } بمعدل { $times } دورة في الثانية
   *[other] تُدار الكتل { $masses } على دائرة نصف قطرها { $radius } بمعدل { $times } دورة في الثانية
  }
run-rests = { $count ->
    [one] العضلة عند المفصل { $joints } ساكنة
    [two] العضلتان عند المفصلين { $joints } ساكنتان
    [few] العضلات عند المفاصل { $joints } ساكنة
    [many] العضلات عند المفاصل { $joints } ساكنة
   *[other] العضلات عند المفاصل { $joints } ساكنة
  }
run-muscles = { $count ->
    [zero] لا عضلة تتحرك في لحظة أخرى أو بزاوية أخرى
    [one] عضلة واحدة تتحرك في لحظة أخرى أو بزاوية أخرى
    [two] عضلتان تتحركان في لحظة أخرى أو بزاوية أخرى
    [few] { $count } عضلات تتحرك في لحظة أخرى أو بزاوية أخرى
    [many] { $count } عضلة تتحرك في لحظة أخرى أو بزاوية أخرى
   *[other] { $count } عضلة تتحرك في لحظة أخرى أو بزاوية أخرى
  }
