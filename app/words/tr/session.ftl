session-cannot = Bu yapılamıyor
session-busy = sahne meşgul; yeniden dene
session-not-resumed = devam edilemedi: { $why }

session-exploded = Cisim patladı
    .setting = { $step } s olan zaman adımı, { $limit } s kararlılık sınırının üzerinde; sınırı belirleyen: { $setting } { $value }. Son iyi durum gösteriliyor. Hemen öncesine dön, ikisinden birini azalt ve devam et; ya da “Sıfırla” düğmesine bas.
    .part = { $step } s olan zaman adımı, { $limit } s kararlılık sınırının üzerinde; sınırı belirleyen sertlik: { $part }. Son iyi durum gösteriliyor. Hemen öncesine dön, onu azalt veya “Otomatik” hesaplama yöntemini seç ve devam et; ya da “Sıfırla” düğmesine bas.
    .otherwise = { $step }. adımdan önce durduruldu: { $what }; { $why }. Son iyi durum gösteriliyor. Hemen öncesine dön, { $remedy } ve devam et; ya da “Sıfırla” düğmesine bas.
session-what-number = { $mass } numaralı kütlenin yeri veya hızı sonlu bir sayı olmayacaktı
session-what-position = { $mass } numaralı kütle çok uzağa gitti ({ $limit } px sınırının ötesine)
session-what-step = buradan atılacak hiçbir adım yeterince kısa değil
session-what-speed = { $mass } numaralı kütle çok hızlandı ({ $limit } px/s sınırının üzerine)
session-why-law = öğreticinin kuvvet yasasının enerjisi yoktur ve bir cismi gittikçe hızlandırabilir
session-why-violent = cisim çok sert hareket ettirildi veya aşırı zorlanmış hâlde kuruldu
session-why-violent-step = cisim bu zaman adımına göre çok sert hareket ettirildi veya aşırı zorlanmış hâlde kuruldu
session-why-small = zaman adımı kararlılık sınırının altında, ama bu sınır bir duruş çevresindeki küçük hareketler için geçerli; büyük veya hızlı olanlar onu aşabilir
session-why-small-law = zaman adımı kararlılık sınırının altında, ama bu sınır bir duruş çevresindeki küçük hareketler için geçerli; büyük veya hızlı olanlar onu aşabilir; ayrıca öğreticinin kuvvet yasasının enerjisi yoktur ve bir cismi gittikçe hızlandırabilir
session-remedy-law = cismi daha yumuşak hareket ettir, sönümü artır veya başka bir kuvvet yasası seç
session-remedy-gently = cismi daha yumuşak hareket ettir veya sönümü artır
session-remedy-step = zaman adımını kısalt, “Otomatik” hesaplama yöntemini seç, sönümü artır veya cismi daha yumuşak hareket ettir
session-cause-linear-stiffness = uzama sertliği
session-cause-linear-damping = uzama sönümü
session-cause-angular-stiffness = bükülme sertliği
session-cause-angular-damping = bükülme sönümü
session-cause-air-friction = hava sürtünmesi
session-cause-one-sided = tek yönlü yaylar
session-cause-resistance = direnç
session-cause-walls = duvarlar
session-cause-fillings = gazlar ve sıvılar
session-cause-contact = temas
session-cause-motors = motorlar
session-cause-pushes = itmeler
session-cause-rails = raylar

session-shape = Bu biçim korunamıyor
    .line = { $why } Çizgi, cismin nereye gittiğini gösterir.
    .button = { $why } “{ $times } kat sertlikle koru” düğmesi bunu sağlar.
    .both = { $why } Çizgi, cismin nereye gittiğini gösterir. “{ $times } kat sertlikle koru” düğmesi bunu sağlar.
    .text = { $why }

session-back-to = Şu sahneye dönüldü: “{ $scene }”
    .undo = “Geri al” yeniden şu sahneye götürür: “{ $scene }”.
    .redo = “Yinele” yeniden şu sahneye götürür: “{ $scene }”.
session-opening = sahnenin açılması: { $scene }
session-own-body = cismin kendi değerleri
session-own-solver = çözücünün kendi değerleri

session-replay-ended = Yeniden oynatma bitti
    .taken = Kontrolü yeniden oynatmadan devraldın.
    .stuck = Devam edemiyor: { $why }.
    .agrees = İşlem kaydıyla uyuşuyor: { $verdict }.
    .differs = İşlem kaydıyla uyuşmuyor: { $verdict }.
session-replayed = { $checks ->
    [one] { $steps } adım yeniden oynatıldı; denetimi tutuyor
   *[other] { $steps } adım yeniden oynatıldı; { $checks } denetimin tümü tutuyor
}
    .digest = { $checks ->
    [one] { $steps } adım yeniden oynatıldı; denetimi tutuyor, özet değeri { $digest }
   *[other] { $steps } adım yeniden oynatıldı; { $checks } denetimin tümü tutuyor, özet değeri { $digest }
}
session-differs = ilk fark { $step }. adımda, t = { $time } s (denetim { $check } / { $checks }; { $agreed }. adımda tutuyor), { $how }
    .elsewhere = ilk fark { $step }. adımda, t = { $time } s (denetim { $check } / { $checks }; { $agreed }. adımda tutuyor), { $how }; kaydedildiği makine { $machine }, bu makine { $here }
session-differs-hidden = fark yerlerde ve hızlarda değil, tuşların, hasarın veya sürtünmenin yaptıklarında
session-differs-apart = kaydedilen bir kütlenin en büyük uzaklığı { $distance }
session-differs-unknown = en büyük uzaklık bilinmiyor
session-too-heavy = bu kare bir sayfada oynatılamayacak kadar ağır; `softrod run --inputs` bunu yapabilir
session-log-plays = bir işlem kaydı oynatılıyor; kaydedilecek başka bir şey yok

session-awaited = { $what } derlenene kadar NumPy ile hareket ediyor; hazır parça: { $ready } / { $count }
session-preparing = hazırlanıyor ({ $what }); hazır parça: { $ready } / { $count }

session-errors-kept = Hatalar büyümüyor: { $tolerance } toleransına uyuluyor.
    .grow = Hatalar bir saniyede × { $factor } büyüyor: { $tolerance } toleransına uyuluyor.
session-errors-step = Hatalar büyümüyor: daha kısa bir zaman adımı onları küçültür.
    .grow = Hatalar bir saniyede × { $factor } büyüyor: daha kısa bir zaman adımı onları küçültür.
session-errors-lost = Hatalar bir saniyede × { $factor } büyüyor: cismin { $seconds } s sonra nerede olacağını hiçbir tolerans güvence altına alamaz.
    .step = Hatalar bir saniyede × { $factor } büyüyor: cismin { $seconds } s sonra nerede olacağını hiçbir zaman adımı güvence altına alamaz.

session-plot-many = bir grafikte { $count } büyüklüğe yer var
session-plot-units = bir grafikte iki birime yer var; şunlara yok: { $units }
session-mode-fast = titreşim { $mode }: periyodu { $period } s, dört zaman adımından kısa
