reading-stretch = uzama
reading-force = kuvvet
reading-length = uzunluk
reading-angle = açı
reading-torque = tork
reading-speed = sürat
reading-vx = vx hızı
reading-vy = vy hızı
reading-momentum-x = x yönündeki momentum
reading-momentum-y = y yönündeki momentum
reading-distance = uzaklık
reading-time-step = zaman adımının sınırına oranı
reading-of = { $owner ->
    [mass] { $what } ({ $number } numaralı kütle)
    [spring] { $what } ({ $number } numaralı yay)
    [joint] { $what } ({ $number } numaralı eklem)
   *[body] { $what } (cismin tümü)
  }
reading-period = periyot ({ $what })
reading-period-of = { $owner ->
    [mass] periyot ({ $number } numaralı kütle)
    [spring] periyot ({ $number } numaralı yay)
    [joint] periyot ({ $number } numaralı eklem)
   *[body] periyot (cismin tümü)
  }

goal-between = { $reading }: { $low } ile { $high } arası
goal-least = { $reading }: en az { $low }
goal-most = { $reading }: en çok { $high }
goal-held = { $goal }, { $seconds } s boyunca

run-choice = { $choice }: { $option }
run-many = { $count ->
   *[other] { $count } kütle yana çekilip bırakılıyor
  }
run-pull = { $mass } numaralı kütle { $way } çekilip bırakılıyor
run-way =
  .right = { $length } sağa
  .left = { $length } sola
  .down = { $length } aşağıya
  .up = { $length } yukarıya
run-ways = { $one } ve { $other }
run-led = { $count ->
    [one] { $masses } numaralı kütle, yarıçapı { $radius } olan bir çemberde saniyede { $times } kez dolaştırılıyor
   *[other] { $masses } numaralı kütleler, yarıçapı { $radius } olan bir çemberde saniyede { $times } kez dolaştırılıyor
  }
run-rests = { $count ->
    [one] { $joints } numaralı eklemdeki kas dinleniyor
   *[other] { $joints } numaralı eklemlerdeki kaslar dinleniyor
  }
run-muscles = { $count ->
    [one] bir kas başka bir anda veya başka bir açıyla hareket ediyor
   *[other] { $count } kas başka bir anda veya başka bir açıyla hareket ediyor
  }
