access-title = Erişilebilirlik ve dil
access-language = Dil
    .hint = Sayfanın dili; kendi sahnelerin kendi dillerinde kalır. Cisim ve geri alınabilenler korunur.
access-letters = Tuş olarak harfler
    .hint = Metinlerini sesle yazdıranlar veya tuşlara yanlışlıkla basanlar için. Ctrl ile kullanılan tuşlar, oklar ve Esc her zaman çalışır.
    .always = her zaman
    .body = odak cisimdeyken
    .never = hiçbir zaman
access-taps = Sürüklemek yerine dokun
    .hint = Bir şeye dokun, sonra gideceği yere dokun. Esc ya da o şeye bir dokunuş daha onu yerine bırakır. Sürüklemek de mümkündür.
access-larger = Daha büyük
    .hint = Her şey daha büyük ve daha kalın.
access-contrast = Daha fazla karşıtlık
    .hint = Harfler ve kenarlar daha belirgin olur.
access-still = Daha az hareket
    .hint = Rüzgâr, görünümler ve işaretler kendiliğinden hareket etmez. Cisim, oynatılınca hareket eder.
access-sound = Ses
    .hint = Grafiklerin, titreşim biçimlerinin, değen ve kopan şeylerin sesi.
access-events = Olayları söyle
    .hint = Ekran okuyucu olanları kısaca söyler: ne koptu, neye değdi, ne durdu, ne tutuldu veya bırakıldı. İki saniyede en çok bir cümle.
access-kept = Bu cihaz bu ayarları saklar.

# While something is picked up by a tap, and after that; $thing is one of the names below, or that of an instrument, a
# bar or a mark.
taps-held = Alındı: { $thing }. Gideceği yere dokun. Esc ya da üstüne bir dokunuş onu yerine bırakır.
taps-put = Konuldu: { $thing }
taps-back = Yerine bırakıldı: { $thing }
taps-nothing = Burada alınacak bir şey yok; duraklatılmış bir cisme dokunmak daha kolaydır.
taps-button = Yerine bırak
taps-selection = seçim
taps-frame = çerçevenin köşesi
taps-cut = kesimin ucu
taps-turn = eklemin serbest açısı
taps-picture = resim
# Of a plot: the end of the part of the time that is to be shown larger.
taps-part = büyütülecek bölümün sonu
