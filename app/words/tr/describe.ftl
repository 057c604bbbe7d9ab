describe-mass = { $count ->
    [one] Tek başına bir kütle.
   *[other] Tek başına { $count } kütle.
}
describe-chain = { $count ->
    [one] Bir zincir: { $masses } kütle, { $springs } yay, { $joints ->
        [0] eklem yok
       *[other] { $joints } eklem
    }.
   *[other] { $count } zincir, her birinde: { $masses } kütle, { $springs } yay, { $joints ->
        [0] eklem yok
       *[other] { $joints } eklem
    }.
}
describe-ring = { $count ->
    [one] Bir halka: { $masses } kütle, { $springs } yay, { $joints ->
        [0] eklem yok
       *[other] { $joints } eklem
    }.
   *[other] { $count } halka, her birinde: { $masses } kütle, { $springs } yay, { $joints ->
        [0] eklem yok
       *[other] { $joints } eklem
    }.
}
describe-tree = { $count ->
    [one] Bir ağaç: { $masses } kütle, { $springs } yay, { $joints ->
        [0] eklem yok
       *[other] { $joints } eklem
    }.
   *[other] { $count } ağaç, her birinde: { $masses } kütle, { $springs } yay, { $joints ->
        [0] eklem yok
       *[other] { $joints } eklem
    }.
}
describe-net = { $count ->
    [one] Bir ağ: { $masses } kütle, { $loops } göz oluşturan { $springs } yay, { $joints ->
        [0] eklem yok
       *[other] { $joints } eklem
    }.
   *[other] { $count } ağ, her birinde: { $masses } kütle, { $loops } göz oluşturan { $springs } yay, { $joints ->
        [0] eklem yok
       *[other] { $joints } eklem
    }.
}

describe-free = Cismi hiçbir şey tutmuyor.
    .parts = { $count ->
        [one] Bu parçayı hiçbir şey tutmuyor.
       *[other] Bunları hiçbir şey tutmuyor.
    }
describe-held = Cisim { $mass } numaralı kütlesinden, { $side ->
    [left] sol ucundan
    [right] sağ ucundan
    [top] üstünden
    [bottom] altından
    [leftTop] sol üstünden
    [rightTop] sağ üstünden
    [leftBottom] sol altından
    [rightBottom] sağ altından
   *[inside] uçlarının arasından
} tutuluyor.
    .mass = Kütle { $mass } sabit.
describe-held-many = { $count } kütle sabitlenmiş: { $masses }.
describe-held-most = { $count } kütle sabitlenmiş.

describe-lies = Genişliği { $width }, yüksekliği { $height }.
    .all = Hepsinin genişliği { $width }, yüksekliği { $height }.
describe-piece = { $side ->
    [top] Yukarıdan
   *[left] Soldan
} { $number }. cisim { $masses } numaralı { $count ->
    [one] kütleden
   *[other] kütlelerden
} oluşuyor.
describe-hangs = En alttaki kütlesi, { $mass } numaralı olan, sabitlenmişlerin en yükseğinden { $depth } aşağıda.

describe-still = Cisim hareketsiz.
    .away = Şu an hareket etmiyor; denge konumundan { $length } uzakta.
    .nearly = Cisim neredeyse hareketsiz: { $length } değerinden az salınıyor.
    .all = Hiçbir şey hareket etmiyor.
describe-moves = En hızlı kütlesi, { $mass } numaralı olan, { $way } { $speed } süratle hareket ediyor.
    .all = En hızlı kütle, { $mass } numaralı olan, { $way } { $speed } süratle hareket ediyor.
describe-drifts = Cisim bütün olarak { $whole } { $speed } süratle hareket ediyor.
describe-turns = { $sense ->
    [clockwise] Saat yönünde
   *[counterclockwise] Saat yönünün tersine
} saniyede { $degrees } derece dönüyor.
describe-way = { $way ->
    [right] sağa doğru
    [upRight] sağ yukarıya doğru
    [up] yukarıya doğru
    [upLeft] sol yukarıya doğru
    [left] sola doğru
    [downLeft] sol aşağıya doğru
    [down] aşağıya doğru
   *[downRight] sağ aşağıya doğru
}

describe-stretched = En çok { $spring } numaralı yay gerilmiş: %{ $percent } uzamış.
describe-squeezed = En çok { $spring } numaralı yay sıkışmış: %{ $percent } kısalmış.
describe-touching = { $count ->
    [one] Bir kütle bir şeye değiyor.
   *[other] { $count } kütle bir şeye değiyor.
}
describe-broken = { $count ->
    [one] Bir yay kopmuş.
   *[other] { $count } yay kopmuş.
}
describe-yielded = { $count ->
    [one] Bir yay veya eklem kalıcı biçim değiştirmiş.
   *[other] { $count } yay ve eklem kalıcı biçim değiştirmiş.
}

describe-swings = Kendi hâline bırakılırsa { $period } saniyede bir salınım yapar ve her salınımda genliği %{ $percent } azalır.
describe-swings-on = Kendi hâline bırakılırsa { $period } saniyede bir salınım yapar ve genliği neredeyse hiç azalmaz.

describe-same = O zamandan beri hiçbir şey değişmedi.
describe-moved = O zamandan beri { $way } { $length } gitti.
describe-broke = { $count ->
    [one] O zamandan beri bir yay koptu.
   *[other] O zamandan beri { $count } yay koptu.
}
describe-built = O zamandan beri değiştirildi.

describe-part-mass = { $mass } numaralı kütle, { $weight }, konumu x = { $x }, y = { $y }.
describe-part-held = Sabitlenmiş.
    .hand = Elinde tutuyorsun.
describe-part-still = Hareketsiz.
describe-part-moves = { $way } { $speed } süratle hareket ediyor.
describe-part-alone = Ona bağlı yay yok.
describe-part-joined = { $count ->
    [one] { $springs } numaralı yay onu { $masses } numaralı kütleye bağlıyor.
   *[other] { $springs } numaralı yaylar onu { $masses } numaralı kütlelere bağlıyor.
}
describe-part-joined-most = { $count ->
    [one] { $count } yay onu başka bir kütleye bağlıyor.
   *[other] { $count } yay onu başka kütlelere bağlıyor.
}
describe-part-touches = Bir şeye değiyor.
describe-part-spring = { $spring } numaralı yay { $one } ve { $other } numaralı kütleleri bağlıyor.
describe-part-length = Uzunluğu { $length }, serbest uzunluğu { $rest }.
describe-part-strain = %{ $percent } { $sense ->
    [stretched] uzamış
   *[squeezed] kısalmış
}.
describe-part-force = { $sense ->
    [pulls] Uçlarını { $force } kuvvetle birbirine çekiyor
   *[pushes] Uçlarını { $force } kuvvetle birbirinden itiyor
}.
describe-part-broken = Kopmuş.
describe-part-yielded = Kalıcı biçim değiştirmiş.
describe-part-muscle = Serbest uzunluğunu en çok %{ $percent } değiştiren bir kas.
describe-part-joint = { $joint } numaralı eklem { $mass } numaralı kütlede, { $one } ve { $other } numaralı yayların arasında.
describe-part-corner = Bu yayların arasındaki köşe { $corner }.
describe-part-angle = Açısı { $angle }, serbest açısı { $rest }.
describe-part-torque = Torku { $torque }.
describe-part-bends = Serbest açısını en çok { $degrees } değiştiren bir kas.
describe-part-motor = Bir motor onu en çok { $speed } süratle döndürüyor.

news-broke = { $count ->
    [one] Bir yay koptu.
   *[other] { $count } yay koptu.
}
news-touched = { $by ->
    [floor] Cisim zemine değiyor.
    [wall] Cisim bir duvara değiyor.
   *[body] Cisim başka bir cisme veya kendine değiyor.
}
news-rest = Cisim durdu.
news-exploded = Cisim patladı ve durduruldu.
news-grabbed = { $mass } numaralı kütle elde.
news-dropped = { $mass } numaralı kütle bırakıldı.
news-running = Hareket ediyor.
    .paused = Duraklatıldı.
news-step = { $number }. adım: { $title }

describe-title = Betimleme
describe-close = Betimlemeyi kapat
