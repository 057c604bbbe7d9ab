class-title = softrod: sınıf
class-needs-javascript = Sınıf için JavaScript gerekli; burada kapalı.
class-blocked = Sayfa yüklendi, ama canlı bağlantısı kurulamıyor: yolda bir şey WebSocket bağlantılarını engelliyor. Başka bir ağ dene, örneğin öğretmenin bilgisayarının mobil erişim noktasını.
class-over = Ders bitti.
class-why = Neden? Tek cümleyle cevapla.
class-hand-in = Bulduğunu teslim et.
class-goal = Hedef: { $goal }
class-goal-met = Ulaşıldı: { $goal }
class-found = Sınıfın bulduğu
class-qr-code = QR kodu: { $address }
class-plot = { $what } – { $over } grafiği: { $count } nokta
  .law = { $what } – { $over } grafiği: { $count } nokta; { $law }
class-plot-you = sen: { $value }
class-grip = Tahmininin { $mass } numaralı kütlesi: ok tuşlarıyla hareket ettir
class-grips = Tahminin
class-moved-mass = Kütle { $mass }: { $moved }
class-moved =
  .lower = { $length } daha aşağıda
  .higher = { $length } daha yukarıda
  .left = { $length } solda
  .right = { $length } sağda
class-where-put = tahminleriniz

## Öğrencinin sayfası.

seat-region = Sınıf
seat-nothing-kept = Verdiklerinden hiçbiri burada saklanmıyor.
seat-away-alone = Bağlı değil: cismin burada hareket etmeyi sürdürüyor, ama bu sayılmaz. Yeniden bağlanılıyor…
seat-hand-up = El kaldır
seat-hand-is-up = Elin havada
seat-on-page = Yerin şimdi bu tarayıcının başka bir sayfasında.
seat-on-device = Yerin şimdi başka bir cihazda.
seat-come-back = Buraya geri al
seat-who = Sen kimsin? Adını yaz ki öğretmenin bunların kimin cevapları olduğunu bilsin.
seat-your-name = Adın
seat-name-me = Bu benim
seat-on-wall = Şimdi tahtada seninki var.
seat-follow = Öğretmeninkine bak
seat-own-body = Kendi cismime dön
seat-about = Bu yer
seat-why = Soru ve gerekçen
seat-waiting = Henüz öğretmenine ulaşmadı: burada saklanıyor ve gönderilebildiği anda gönderilecek.
seat-letters = Tahtadaki dört harf
seat-come-in = Gir

seat-is-in = İçeridesin. Birazdan başlıyor.
seat-look = Öne bak.
seat-teacher-away = Öğretmeninin sayfası bir anlığına yok: bekle.
seat-gathered = Öne bak: bu, öğretmeninin cismi. Seninki bekliyor.
seat-follows = Bu, öğretmeninin cismi. Seninki bekliyor.
seat-paused = Duraklatıldı: öne bak.
seat-can-change = Hâlâ değiştirebilirsin. Henüz başka kimse göremiyor.
seat-ask-drag = Soluk cismi, başladıktan { $seconds } s sonra olacağı yere taşı. Henüz başka kimse göremiyor.
seat-ask-both = Soluk cismi, başladıktan { $seconds } s sonra olacağı yere taşı ve bir cevap seç. Henüz başka kimse göremiyor.
seat-ask-choose = Bir cevap seç. Henüz başka kimse göremiyor.
seat-ask-again = Bir daha seç. Henüz başka kimse göremiyor.
seat-try = Dene: bu cisim senin.

seat-home-drag = Soluk cismi, başladıktan { $seconds } s sonra olacağı yere taşı. Sonra hareket başlar.
seat-home-both = Soluk cismi, başladıktan { $seconds } s sonra olacağı yere taşı ve bir cevap seç. Sonra hareket başlar.
seat-home-choose = Bir cevap seç. Sonra hareket başlar.
seat-late-now = Şimdi verdiklerin geç sayılır.
seat-home-own = Şimdi sıra sende: bu cisim senin.
seat-step = { $number }. adım
seat-step-done = { $number }. adım, tamamlandı
seat-next-step = Sonraki: adım { $number } / { $steps }
seat-to-do = { $count ->
    [one] Yapılacak adım: { $steps }.
   *[other] Yapılacak adımlar: { $steps }.
  }
seat-all-done = Bütün adımlar tamamlandı. Bu sayfayı kapatabilirsin.
seat-told-on = Doğru cevabı göreceğin tarih: { $date }.

seat-watch = İzle:
seat-chose-before = Daha önce seçtiğin: { $choice }
seat-chose = { $late ->
    [yes] Seçtiğin: { $choice } (geç: cevaplar söylendikten sonra).
   *[no] Seçtiğin: { $choice }.
  }
seat-right = Doğru cevap: { $choice }.

seat-predict = Burada olacak
  .place = Teslim et: { $place }
seat-predicted = Tahminin teslim edildi
  .place = Tahminin teslim edildi: { $place }
seat-handed-moved = Cevaplar gösteriliyor: tahminin, taşıdığın hâliyle teslim edildi.
seat-step-left = Biraz sola
seat-step-right = Biraz sağa
seat-step-up = Biraz yukarıya
seat-step-down = Biraz aşağıya

seat-because = Çünkü
seat-send = Gönder
seat-change = Değiştir
seat-sent = Gönderildi ✓
seat-pause = Duraklat
seat-play = Oynat
seat-reset = Sıfırla
seat-slow = Dörtte bir hızda
seat-reading = { $what }: { $reading }
seat-no-reading = Henüz okunacak bir şey yok: bir süre hareket etsin.
seat-hand-in = Teslim et: { $reading }
  .instead = Bunun yerine teslim et: { $reading }
seat-hand-in-it = Teslim et
  .instead = Onun yerine bunu teslim et
seat-hand-in-run = Bu denemeyi teslim et
  .instead = Onun yerine bu denemeyi teslim et
seat-handed = { $late ->
    [yes] Teslim edildi (geç: cevaplar söylendikten sonra).
   *[no] Teslim edildi.
  }
  .text = { $late ->
    [yes] Teslim edildi: { $text } (geç: cevaplar söylendikten sonra).
   *[no] Teslim edildi: { $text }.
  }

seat-first = Birinciniz
seat-second = İkinciniz
seat-another-name = Başka ad
seat-two = İki kişiyiz
seat-move = Başka bir cihazla devam et
seat-move-digits = Öteki cihaza şunu yaz: { $digits }
seat-had = Başka bir cihazda yerim vardı: onun iki rakamı
seat-take-over = Devral

## Öğretmenin her aşamada sınıfa söyledikleri ve (.do) yaptıkları.

guide-lobby = Tahtadaki adresi açın ve dört harfi yazın.
  .do = Tahta sayfasını projeksiyona yansıtın. Herkes gelince devam edin.
guide-show = Cisme bakın: onu ne tutuyor, ne çekiyor?
  .before = Parçaları gösterin. “Oynat” düğmesine henüz basmayın: cisim sorudan sonra harekete geçer.
  .do = Parçaları gösterin. Cismi bırakmak için “Oynat” düğmesine basın: sorunun konusu olan bölüm daha sonra gelir.
guide-drag = Soluk cismi, başladıktan { $seconds } s sonra olacağı yere sürükleyin.
guide-ask = Herkes cevap verene kadar bekleyin. Neyin doğru olduğunu söylemeyin.
guide-again = Bir dakika boyunca yanınızdaki arkadaşınızı ikna etmeye çalışın. Sonra yeniden cevaplayın.
  .do = Dinleyin. Neyin doğru olduğunu söylemeyin.
guide-results = Neden o cevabı seçtiğini kim söylemek ister?
  .do = Farklı cevap veren iki öğrenciyi dinleyin. Doğru cevabı henüz vermeyin.
guide-changed = Kim fikrini değiştirdi, neden?
  .do = Doğru cevabı henüz vermeyin: hareket onu gösterecek.
guide-run = Cismin ne yaptığını izleyin.
  .do = Herkes ne olduğunu görene kadar hareket sürsün.
guide-run-new = Cismin ne yaptığını izleyin. Yeni olan: { $runs }
guide-run-stops = Hareket { $seconds } s sonra durur. Sonucu tahminlerle karşılaştırın.
guide-reveal = Cevap bu. Nedenini yanınızdaki arkadaşınıza anlatın.
  .predicted = Tahtada cismin yanında önce tahminler, sonra doğru cevap görünür. Konuşmadan önce biraz bekleyin.
  .do = Tahtada doğru cevap görünür. Konuşmadan önce biraz bekleyin.
guide-explain = İki cevaba yıldız verin: sonraki aşamada tahtada görünürler. Sonra kendi sözcüklerinizle açıklayın: { $because }
guide-try = Sınıfta dolaşın. El kaldıranlar sağda görünür.
guide-collect = Teslim edin: { $collects }.
guide-plot = Çoğu öğrenci teslim edince sınıfın grafiğine birlikte bakın: ne söylüyor? Varsa “Yasayı göster” düğmesine basın.
guide-collected = Çoğu öğrenci teslim edince birini tahtada gösterin.

## Sunucunun bir sınıf sayfasına söyledikleri.

class-refuse-together = Sınıf hep birlikte ilerliyor.
class-refuse-no-home-step = Ödevde böyle bir adım yok.
class-refuse-no-place = Derste böyle bir bölüm yok.
class-refuse-sealed = Tümü gösterilmeden kimse cevapları göremez.
class-refuse-no-bodies = Şu anda öğrencilerin kendi cisimleri yok.
class-refuse-gathered = Şu anda herkes öğretmeninkine bakıyor.
class-refuse-begun = Sınıf başladı: artık başka bir ders seçilemez.
class-refuse-steps = Bir sınıfta en çok { $most } adım olabilir; bu sahnedeki adım sayısı: { $steps }.
class-refuse-closed = Sınıf başladı; öğretmeninden kapıyı açmasını iste.
class-refuse-network = Ağında { $seats } yer var, bir ağa daha fazlası verilmez; öğretmenin birkaçını kaldırabilir.
class-refuse-removed = Öğretmen bu yeri kapattı.
class-refuse-full = Sınıf dolu: { $seats } yeri var.
class-refuse-names = Bu sınıfta adlar hazır verilir.
class-refuse-no-name = Bir adda en az bir harf olmalı.
class-refuse-same-name = Bu ad başka birinde var.
class-refuse-digits = Şu anda bu numaralı bir yer yok.
class-refuse-own-answers = Bu cihazda kendi cevapları olan bir yer zaten var.
class-refuse-not-yours = Bu cevap başka birinin.
class-refuse-one = Burada yalnızca bir kişi oturuyor.
class-refuse-no-step = Derste böyle bir adım yok.
class-refuse-not-asked = Sınıfa bu sorulmadı.
class-refuse-has-run = Hareketi gördün: ilk cevabın geçerli.
class-refuse-shown = Cevaplar gösterildi; seninki olduğu gibi kaldı.
class-refuse-answers = Bir yerden en çok { $most } cevap verilebilir.
class-refuse-no-seat = Böyle bir yer yok.
class-refuse-no-answer = Böyle bir cevap yok.
class-refuse-no-choice = Sorunun böyle bir seçeneği yok.
class-refuse-no-such-place = Bu cisim orada olamaz.
class-refuse-no-letter = Bir cümlede en az bir harf olmalı.
class-at-goal = hedefe ulaşıldı
class-not-at-goal = hedefe ulaşılmadı
class-refuse-tries = Çok fazla kez denendi; devam etmek için sayfayı yeniden yükle.
class-refuse-begin = Bu adım başlayamıyor: { $reason }.
class-refuse-other-page = Bu yer şimdi başka bir sayfada.
class-refuse-cannot-begin = Bu adım başlayamıyor.
class-refuse-no-run = Şu anda teslim edilecek bir deneme yok.
class-refuse-replay = Bir kayıt oynatılıyor; teslim edilecek bir şey yok.
class-refuse-code = Şu anda burada kodu { $code } olan bir sınıf yok.
seat-try-again = Başka değerler dene ve “Sıfırla” düğmesine bas.
class-told-at = { $day } { $month ->
    [1] Ocak
    [2] Şubat
    [3] Mart
    [4] Nisan
    [5] Mayıs
    [6] Haziran
    [7] Temmuz
    [8] Ağustos
    [9] Eylül
    [10] Ekim
    [11] Kasım
   *[12] Aralık
  }, saat { $time }

## Tahta: herkesin projeksiyonda gördüğü.

class-answered = { $done } / { $all } kişi cevapladı
class-wrote = { $done } / { $all } kişi bir cümle yazdı
class-handed-in = { $done } / { $all } kişi teslim etti
wall-nobody = Henüz kimse yok mu? Ağlar cihazları birbirinden ayırabilir: bu dizüstü bilgisayarın mobil erişim noktasını deneyin.
wall-way-in = { $address } adresini açın ve { $code } yazın
wall-scan = Bunu tarayın veya { $address } adresini açıp şunu yazın:
wall-here = { $count } kişi burada
wall-step = Adım { $number } / { $steps }
wall-now = Şimdi: { $runs }
wall-where = Başladıktan { $seconds } s sonra nerede olacak?
wall-next = Sonra: nedenini yanınızdaki arkadaşınıza anlatın.
wall-trying = { $count ->
   *[other] deniyor
  }
wall-exploded = { $count ->
   *[other] patladı
  }
wall-untouched = { $count ->
   *[other] dokunulmadı
  }
wall-at-goal = { $count ->
   *[other] hedefte
  }

## Öğretmenin masası.

desk-lead = Söylenecekler ve yapılacaklar
desk-room = Sınıf
desk-over = Ders bitti
desk-nothing-kept = Verilenlerden hiçbiri bu bilgisayarda saklanmıyor.

desk-here = { $count } kişi burada
desk-wall = Tahta
desk-controls = Kontroller
  .label = Kendi cismimin kontrolleri
desk-not-kept = kaydedilmiyor
desk-saving = kaydediliyor…
desk-pupils-type = Öğrenciler { $address } adresini açıp { $code } yazar.
desk-more = Daha fazla
desk-come-in = Öğrenciler nasıl girer

desk-lobby = Giriş
desk-show = Bana bakın
desk-ask = Sor
  .again = Yeniden sor
desk-results = Cevapları göster
  .again = Cevapları yeniden göster
desk-run = Hareketi başlat
desk-reveal = Doğru cevabı göster
desk-explain = Bir cümle yazsınlar
desk-try = Denesinler
desk-collect = Topla
desk-step = { $number }. adım
desk-steps = Adım
desk-phase = Aşama { $number } / { $phases }
desk-minutes = şimdiye kadar { $minutes } dk
desk-say = Söyle
desk-do = Yap
desk-next = Sonraki: { $place }
desk-last = Bu son adımdı.
desk-back = Geri
  .label = Geri dön: { $place }
desk-all-phases = Bütün aşamalar

desk-teach = %{ $part } doğru: bir kez daha anlatın.
  .some = Cevap veren { $votes } kişinin %{ $part } kadarı doğru: bir kez daha anlatın.
desk-pairs = %{ $part } doğru: ikişer ikişer konuşsunlar, sonra yeniden sorun.
  .some = Cevap veren { $votes } kişinin %{ $part } kadarı doğru: ikişer ikişer konuşsunlar, sonra yeniden sorun.
desk-on = %{ $part } doğru: devam edin.
  .some = Cevap veren { $votes } kişinin %{ $part } kadarı doğru: devam edin.
desk-replay = Yeniden, yavaşça
  .now = Yavaşça, baştan…
desk-gather = Herkes benimkine baksın
desk-pause = Herkesi duraklat
desk-reset = Herkesinkini sıfırla
desk-give-mine = Herkese benimkini ver
  .confirm = Herkese cisminiz şimdiki hâliyle verilsin mi? Ellerindeki cisimler silinir.
desk-law = Yasayı göster
desk-open = Kapıyı aç
desk-close = Kapıyı kapat
desk-own-names = Adlarını kendileri yazsın
desk-given-names = Adları biz verelim
desk-sheet = Yazdırılacak ders planını kaydet
desk-zip = Tümünü zip olarak kaydet
desk-end = Bitir
  .confirm = Ders bitirilsin mi? Verilen her şey silinir.

desk-home-until = Ödev, son tarih: { $date }
  .about = Öğrenciler siz olmadan da istedikleri zaman girer. Doğru cevapları o tarihte veya siz söyleyince görürler.
desk-home-told = Ödev: cevaplar söylendi
  .about = Herkes doğru cevapları görüyor. Şimdi gelenler geç sayılır.
desk-tell = Doğru cevapları şimdi söyle
  .confirm = Doğru cevaplar şimdi herkese söylensin mi? Bundan sonra gelenler geç sayılır.
desk-home-step = { $number }. { $title }: cevaplayan { $answered }, teslim eden { $handed }

desk-lesson = Ders
desk-which-lesson = Hangi ders?
desk-lesson-steps = { $count } adımı var.
desk-address = Adres
desk-which-network = Öğrenciler hangi ağda?
desk-networks = Bu bilgisayar birden fazla ağda. Öğrenci cihazlarının adresleri aynı biçimde başlar.
desk-lets-in = Ağ onları içeri alıyor mu?
desk-scan = Bunu öğrencilerin ağındaki bir telefonla tarayın veya şu adresi açın: { $address }
desk-finds-nothing = Bir telefon bu adreste hiçbir şey bulamazsa ağ cihazları birbirinden ayırıyordur: bu bilgisayarın mobil erişim noktasını kullanın.

desk-tried-in-vain = Bir cihaz: katılamıyor; nedenini kendisi söylüyor.
desk-tried = Bir cihaz: her şey yolunda, { $ms } ms, saniyede { $rate } görüntü
desk-tried-doubts = Bir cihaz: çalışıyor ve nelere dikkat edileceğini söylüyor, { $ms } ms, saniyede { $rate } görüntü
desk-projector = Tahta sayfasını projeksiyona yansıtın
desk-open-wall = Tahta sayfasını aç
desk-way-in = Tahtada bu da büyük görünür: öğrenciler buradan girer.

desk-files = Dosyalardan gelen cevaplar
desk-from-files = Dersi dosya olarak alan öğrencilerden: geç cevap sayılırlar, her biri bir kez.
desk-lesson-file = Dersi onlar için dosya olarak kaydet
desk-their-files = Onların dosyaları
desk-codes = Ya da QR kodlarının metni, taranmış veya yapıştırılmış
desk-take = Al
desk-file-too-long = Bu dosya bir dersin cevapları için fazla uzun.
desk-brought = { $name }: { $count } cevap.
desk-brought-known = { $name }: { $count } cevap, daha önce getirilmiş olan: { $known }.
desk-brought-goals = { $count ->
    [one] Dosyanın kendisine göre hedefine ulaşılan adım: { $steps }.
   *[other] Dosyanın kendisine göre hedefine ulaşılan adımlar: { $steps }.
  }

desk-count-handed-in = { $count ->
   *[other] teslim etti
  }
desk-count-trying = { $count ->
   *[other] deniyor
  }
desk-count-exploded = { $count ->
   *[other] patladı
  }
desk-count-idle = { $count ->
   *[other] hiçbir şeyi değiştirmedi
  }

desk-chose = Seçtikleri
  .now = Şimdiye kadar seçtikleri
desk-sealed = yalnızca siz görüyorsunuz
desk-most = { $count } kişi “{ $choice }” seçti: birine nedenini sorun.
desk-predicted = { $count } kişi bir tahmin sürükledi.
  .some = { $count } / { $all } kişi bir tahmin sürükledi.
desk-found = Şimdiye kadar buldukları

desk-who = Kimler burada
desk-who-away = { $here }; uzakta { $away }
desk-nobody = Henüz kimse yok.
desk-name-two = { $name } (iki kişi)
desk-two = iki kişi
desk-away = uzakta
desk-follows = sizinkine bakıyor
desk-done = { $done } / { $steps } adım
desk-moving = hareket ediyor
desk-untouched = dokunulmadı
desk-at-rest = hareketsiz
desk-paused = duraklatıldı
desk-exploded = patladı
desk-goal-reached = hedefe ulaşıldı
desk-on-wall = tahtada
desk-has-predicted = tahmin etti
desk-has-answered = cevapladı
desk-hand = el kaldırdı
desk-lower-hands = Elleri indir
desk-to-wall = Tahtada göster
desk-off-wall = Tahtadan kaldır
desk-reset-one = Bunu sıfırla
desk-to-all = Herkese dön
desk-move = Başka bir cihaza taşı
desk-move-digits = Öteki cihazda: { $digits }
desk-move-how = Orada girin, “Bu yer” seçeneğini seçin ve { $digits } yazın.
desk-remove = Kaldır
  .confirm = Şu yer kapatılsın mı: { $name }? Verdikleri de silinir.

desk-work = Teslim edilenler: { $count }
desk-lines = Cümleler: { $count }
desk-predictions = Tahminler: { $count }
desk-gave = Verilen: { $what }
desk-by = { $name }: { $what }
desk-a-prediction = bir tahmin
desk-a-run = bir deneme
desk-late = { $what } (geç)
desk-doubt = { $what }: { $doubt }
desk-star = Bu cümleyi tahtada göster; yazan: { $name }
desk-show-body = Cismi tahtada göster: { $name }
desk-show-prediction = Yalnızca bu tahmini tahtada göster: { $name }

desk-not-possible = Bu mümkün değil
desk-cannot-begin = Bu adım başlayamıyor
desk-no-zip = Zip oluşturulamadı
desk-no-file = Dersin dosyası oluşturulamadı
desk-no-sheet = Ders planı oluşturulamadı
desk-the-run = deneme
desk-unkept-title = Sınıf kaydedilmiyor
desk-unkept = { $reason }. Öğrencilerin şimdi verdikleri onların sayfalarında bekliyor; sayfalar kapatılırsa kaybolur. Sınıfın bulunduğu bilgisayarın diskinde yer açın veya zip dosyasını şimdi alın.
desk-kept-title = Sınıf yeniden kaydediliyor
desk-kept = Verilen her şey diskte.
desk-goes-on-title = Sınıf devam ediyor
desk-goes-on = { $folder } klasörü silinemiyor: { $reason }.
class-refuse-no-body = Şu anda bu yerin kendi cismi yok.
class-refuse-no-replay = Yeniden gösterilecek bir deneme yok.
class-refuse-replay-broken = Deneme yeniden gösterilemiyor: { $reason }.
class-refuse-classes = Bir sunucuda en çok { $most } sınıf olabilir.
class-refuse-scenes = Bir sınıfta en çok { $most } adım olabilir; bu sahnelerdeki adım sayısı: { $steps }.
class-refuse-no-code = Bu bir cevap kodu değil: kod SR1 ile başlar, harf ve rakamlardan oluşur.
class-refuse-no-file = Bu dosyada bir dersin cevapları yok.
class-refuse-misread = Kodun bir harfi yanlış okundu: yeniden tarayın.
class-refuse-other-steps = Bu cevaplar, adım sayısı farklı olan bir dersin.
class-refuse-empty = Bunda henüz cevap yok.
class-refuse-other-lesson = Bu cevaplar bu sınıfın dersine değil, başka bir derse ait.

class-doubt-begins = kayıt şununla başlıyor: { $what }.
class-doubt-goes-on = kayıt şununla devam ediyor: { $what }.
class-doubt-begins-other = kayıt, adımın sahnesiyle değil başka bir sahneyle başlıyor.
class-doubt-goes-on-other = kayıt, adımın sahnesiyle değil başka bir sahneyle devam ediyor.
class-doubt-sets = kayıt, bu adımda kaydırıcısı olmayan bir şeyi ayarlıyor: { $what }.
class-doubt-never = kayıt, cismin hiç bulunmadığı bir durumdan devam ediyor; baştan başlanıp o deneme teslim edilmeli.
class-doubt-long = kayıt çok uzun; sınır: { $what }.

## Öğretmenin eve götürdüğü zip.

zip-readme = 
    Bir sınıfın verdikleri: { $steps } adım, { $seats } yer.

    answers.csv      seçimler, cümleler ve teslim edilenler, her biri bir satırda
    found.csv        ne bulunduğu ve ayarın değeri, her deneme bir satırda
    predictions.csv  kütlelerin tahmin edilen yerleri, sahnenin birimleriyle, her kütle bir satırda
    scenes/          sınıfın işledikleri; `softrod class scenes/*.json` bunları başka bir sınıfla işler
    logs/            teslim edilen denemeler; `softrod run --inputs DOSYA` birini yeniden yapar
    pictures/        cisimlerin teslim edildikleri andaki hâlleri

    Tablolarda ondalık virgül, sütunların arasında noktalı virgül vardır.

    { $names } Ders bitirilince bunlardan hiçbiri, sınıfın bulunduğu bilgisayarda kalmaz.
zip-typed-names = Bazı yerlerin adlarını öğrenciler yazdı.
zip-given-names = Yerlerin adlarını sınıf verdi.

zip-step = adım
zip-title = başlık
zip-asked = kaçıncı soruluş
zip-seat = yer
zip-name = ad
zip-pupil = öğrenci
zip-kind = tür
zip-answer = cevap
zip-right = doğru
zip-late = geç
zip-starred = yıldızlı
zip-over = yatay eksen
zip-over-unit = yatay eksenin birimi
zip-setting = ayar
zip-what = büyüklük
zip-unit = birim
zip-found = bulunan
zip-doubt = şüphe
zip-mass = kütle
zip-x = x
zip-y = y

zip-vote = seçim
zip-line = cümle
zip-work = teslim
zip-yes = evet
zip-no = hayır
